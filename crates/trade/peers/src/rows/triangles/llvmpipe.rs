//! Mesa's llvmpipe, in a process of its own: the number of its threads is fixed when it starts.

#[cfg_attr(not(feature = "llvmpipe"), path = "llvmpipe/no_renderer.rs")]
mod renderer;

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::{env, io};

use crate::race::{Clock, Elsewhere};

use super::Form;
use super::picture::{Drawn, FARTHEST, Picture};
use renderer::Renderer;

/// The process, as seen by the one that runs the race.
pub struct Llvmpipe {
    process: Child,
    orders: ChildStdin,
    answers: BufReader<ChildStdout>,
    clock: Clock,
    /// What it calls itself.
    pub renderer: String,
}

impl Llvmpipe {
    /// Starts it with so many threads for pixels; 0: its own thread does everything.
    ///
    /// Otherwise a sentence that says why there is none.
    pub fn start(form: Form, threads: usize, clock: Clock) -> Result<Self, String> {
        let failed = |error: io::Error| format!("its process does not run: {error}");
        let program = env::current_exe().map_err(failed)?;
        let mut process = Command::new(program)
            .arg("--llvmpipe")
            .arg(form.to_string())
            .env("LP_NUM_THREADS", threads.to_string())
            .env("LIBGL_ALWAYS_SOFTWARE", "1")
            .env("GALLIUM_DRIVER", "llvmpipe")
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(failed)?;
        let pipes = (process.stdin.take(), process.stdout.take());
        let (Some(orders), Some(answers)) = pipes else {
            return Err("its process has no pipes".to_owned());
        };
        let mut llvmpipe = Self {
            process,
            orders,
            answers: BufReader::new(answers),
            clock,
            renderer: String::new(),
        };
        let answer = llvmpipe.answer().map_err(failed)?;
        match answer.split_once(' ') {
            Some(("ready", renderer)) => {
                llvmpipe.renderer = renderer.to_owned();
                Ok(llvmpipe)
            }
            Some(("absent", sentence)) => Err(sentence.to_owned()),
            _ => Err(format!("its process answered \"{answer}\"")),
        }
    }

    fn answer(&mut self) -> io::Result<String> {
        let mut line = String::new();
        self.answers.read_line(&mut line)?;
        Ok(line.trim_end().to_owned())
    }

    fn order(&mut self, order: &str) -> io::Result<()> {
        writeln!(self.orders, "{order}")?;
        self.orders.flush()
    }

    fn draw(&mut self, repeats: u32) -> io::Result<f64> {
        self.order(&repeats.to_string())?;
        let answer = self.answer()?;
        let mut seconds = answer
            .split(' ')
            .map(|text| text.parse().unwrap_or(f64::NAN));
        let [processor, wall] = [seconds.next(), seconds.next()].map(|s| s.unwrap_or(f64::NAN));
        Ok(match self.clock {
            Clock::Thread | Clock::Process => processor,
            Clock::Wall => wall,
        })
    }

    fn fetch(&mut self, picture: &mut Picture) -> io::Result<()> {
        self.order(FETCH)?;
        self.answers.read_exact(&mut picture.colour)?;
        let mut depth = vec![0; 4 * picture.depth.len()];
        self.answers.read_exact(&mut depth)?;
        for (depth, &bytes) in picture.depth.iter_mut().zip(depth.as_chunks().0) {
            *depth = f32::from_le_bytes(bytes);
        }
        picture.drawn = Drawn::Here;
        Ok(())
    }
}

impl Elsewhere<Picture> for Llvmpipe {
    fn seconds(&mut self, repeats: u32) -> f64 {
        self.draw(repeats).unwrap_or(f64::NAN)
    }

    fn hand_in(&mut self, picture: &mut Picture) {
        if self.fetch(picture).is_err() {
            // Nothing is lit: not the same work.
            picture.depth.fill(FARTHEST);
        }
    }
}

impl Drop for Llvmpipe {
    fn drop(&mut self) {
        // It has nothing to finish; if it cannot be ended, it ends with its input.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The order to send colours and depths, four bytes a pixel each.
const FETCH: &str = "fetch";

/// The process itself: answers orders until there are no more.
pub fn serve(form: Form) -> io::Result<()> {
    let mut answers = io::stdout().lock();
    let renderer = Renderer::new(form).and_then(|renderer| {
        // The first time it compiles its shaders.
        renderer.draw()?;
        Ok(renderer)
    });
    let renderer = match renderer {
        Ok(renderer) => renderer,
        Err(sentence) => return writeln!(answers, "absent {sentence}"),
    };
    writeln!(answers, "ready {}", renderer.name())?;
    answers.flush()?;
    for order in io::stdin().lines() {
        let order = order?;
        if order == FETCH {
            let (colour, depth) = renderer.picture().map_err(io::Error::other)?;
            answers.write_all(&colour)?;
            answers.write_all(&depth)?;
        } else if let Ok(repeats) = order.parse::<u32>() {
            let mut done = Ok(());
            let mut wall = 0.0;
            let processor = Clock::Process.time(|| {
                wall = Clock::Wall.time(|| {
                    done = (0..repeats).try_for_each(|_| renderer.draw());
                });
            });
            done.map_err(io::Error::other)?;
            writeln!(answers, "{processor} {wall}")?;
        }
        answers.flush()?;
    }
    Ok(())
}
