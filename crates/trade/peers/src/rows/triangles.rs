//! 100 352 triangles of a bumpy sphere into a z-buffer: with colours, and depth alone as for a shadow map.

mod euc;
mod euc_buffers;
mod form;
mod limit;
pub mod llvmpipe;
mod mesh;
mod ours;
mod picture;
mod plain;
mod retrofire;

use rayon::ThreadPoolBuilder;

use crate::measured::{Against, Goal, Measured};
use crate::race::{Clock, Race, Rounds};

use euc::Euc;
pub use form::{COLOURED, Form, SHADOW_MAP};
use limit::Limit;
use mesh::Ball;
use ours::Ours;
use picture::Picture;
use plain::Plain;
use retrofire::Retrofire;

const LLVMPIPE: &str = "llvmpipe";

/// On one thread, in processor time, against all; on several, in time by the clock, against llvmpipe, which alone has them.
pub fn row(name: &str, form: Form, number_of_threads: usize, rounds: Rounds) -> Measured {
    let ball = Ball::new();
    let items = ball.triangles.len() as f64;
    let work = form.described(ball.triangles.len(), number_of_threads);
    let mut picture = Picture::new(form.size, form.coloured);
    let threads = ThreadPoolBuilder::new()
        .num_threads(number_of_threads)
        .build();
    let threads = match threads {
        Ok(threads) => threads,
        Err(error) => {
            let race = Race::new(name, work, items, "tri", picture);
            return race.note(format!("no threads: {error}")).run(rounds);
        }
    };
    let ours = Ours::new(&ball, form, &threads);
    ours.draw_plain(&mut picture);
    picture.set_ideal();
    let limit = Limit::new(&ball, &picture, &threads);
    let plain = Plain::new(&ball, form.cull);
    let retrofire = Retrofire::new(&ball, form.cull);
    let euc = Euc::new(&ball);

    let alone = number_of_threads == 1;
    let clock = if alone { Clock::Process } else { Clock::Wall };
    let mut race = Race::new(name, work, items, "tri", picture)
        .clock(clock)
        .limit("clear, read mesh, write pixels", |picture: &mut Picture| {
            limit.write(picture)
        });
    if alone {
        race = race
            .peer("plain loop", |picture| plain.draw(picture))
            .peer("retrofire-core", |picture| retrofire.draw(picture))
            .peer("euc", |picture| euc.draw(picture, form.cull));
    }
    race = enter_llvmpipe(race, form, number_of_threads, clock);
    let name = if form.coloured { "draw" } else { "draw_depth" };
    let goals = if alone {
        [Against::Peer(LLVMPIPE), Against::FastestPeer].as_slice()
    } else {
        &[Against::Peer(LLVMPIPE)]
    };
    let at_least = if alone { 2.0 } else { 1.5 };
    let goal = |&against| Goal { at_least, against };
    let goals: Vec<Goal> = goals.iter().map(goal).collect();
    race.ours(name, &goals, |picture| ours.draw(picture))
        .run(rounds)
}

fn enter_llvmpipe<'a>(
    race: Race<'a, Picture>,
    form: Form,
    threads: usize,
    clock: Clock,
) -> Race<'a, Picture> {
    // 0: its own thread does everything.
    let of_its_own = if threads == 1 { 0 } else { threads };
    match llvmpipe::Llvmpipe::start(form, of_its_own, clock) {
        Ok(llvmpipe) => {
            let note = format!(
                "{LLVMPIPE} is {}, LP_NUM_THREADS={of_its_own}",
                llvmpipe.renderer
            );
            race.note(note).peer_elsewhere(LLVMPIPE, llvmpipe)
        }
        Err(sentence) => race.note(format!("no {LLVMPIPE}: {sentence}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::Shown;
    use crate::race::Scene;

    /// Each contestant of this process, in each form, against the plain form of ours.
    #[test]
    fn all_draw_the_same() {
        let threads = ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let ball = Ball::of(40);
        for (coloured, cull) in [(true, false), (true, true), (false, false), (false, true)] {
            let form = Form {
                size: 256,
                coloured,
                cull,
            };
            let mut picture = Picture::new(form.size, coloured);
            let ours = Ours::new(&ball, form, &threads);
            ours.draw_plain(&mut picture);
            picture.set_ideal();
            let ideal = picture.shows();
            let limit = Limit::new(&ball, &picture, &threads);
            let plain = Plain::new(&ball, cull);
            let retrofire = Retrofire::new(&ball, cull);
            let euc = Euc::new(&ball);
            type Draw<'a> = &'a dyn Fn(&mut Picture);
            let contestants: [(&str, Draw<'_>); 4] = [
                ("ours", &|picture| ours.draw(picture)),
                ("plain", &|picture| plain.draw(picture)),
                ("retrofire", &|picture| retrofire.draw(picture)),
                ("euc", &|picture| euc.draw(picture, cull)),
            ];
            for (name, draw) in contestants {
                picture.clear();
                assert!(
                    !Shown::agree(&picture.shows(), &ideal),
                    "a cleared picture is the ideal one"
                );
                draw(&mut picture);
                let shown = picture.shows();
                assert!(
                    Shown::agree(&shown, &ideal),
                    "{form:?}, {name}: {shown:?} is not {ideal:?}"
                );
                // Cleared by themselves: the second time is as the first.
                draw(&mut picture);
                assert_eq!(
                    format!("{shown:?}"),
                    format!("{:?}", picture.shows()),
                    "{name}"
                );
            }
            picture.clear();
            limit.write(&mut picture);
            assert_eq!(
                picture.shows()[0].value,
                ideal[0].value,
                "{form:?}: the limit"
            );
        }
    }
}
