//! A picture of one's own: what a student's code drew beside what is right, written when the test fails.

use std::fmt::Write;
use std::fs;
use std::panic::Location;
use std::path::{Path, PathBuf};

use glam::DVec2;

use crate::show_point;

/// What a mark means; the colours are those of the lecture's figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Drawn, and rightly so; also what is right, in the picture beside.
    Right,
    /// Not drawn, but it should be: hollow, with a question mark.
    Missing,
    /// Drawn, but it should not be: grey, crossed out.
    Extra,
    /// The ideal line or outline: thin and dark.
    Ideal,
    /// What was cut off, passed over or is only a help: thin, grey and dashed.
    Faint,
    /// The light: amber; a point is a small sun.
    Light,
    /// The eye, black.
    Eye,
    /// A vector square to a face: green.
    Normal,
    /// The dark of a shadow: slate.
    Shadow,
    /// One of six things, counted from 0: a colour and a letter from A to F; 6 is 0 again.
    Shade(usize),
}

/// The outline of an ink and the lighter colour of its areas.
fn colours(ink: Ink) -> (&'static str, &'static str) {
    match ink {
        Ink::Right => ("#c05500", "#e0aa80"),
        Ink::Missing => ("#c05500", "#ffffff"),
        Ink::Extra => ("#5a636d", "#d3d8de"),
        Ink::Ideal => ("#161b21", "none"),
        Ink::Faint => ("#6f767c", "none"),
        Ink::Light => ("#c28600", "#f3dca6"),
        Ink::Eye => ("#000000", "#c6cdd4"),
        Ink::Normal => ("#008561", "#99cec0"),
        Ink::Shadow => ("#4a5766", "#a3adb8"),
        Ink::Shade(k) => match k % 6 {
            0 => ("#0072b2", "#99c7e0"),
            1 => ("#c05500", "#e0aa80"),
            2 => ("#008561", "#99cec0"),
            3 => ("#a15080", "#d9b9cc"),
            4 => ("#8f6200", "#d2c099"),
            _ => ("#4a5766", "#b7bcc2"),
        },
    }
}

#[derive(Clone, Debug)]
enum Mark {
    Pixel(DVec2),
    Segment(DVec2, DVec2),
    Arrow(DVec2, DVec2),
    Stick(DVec2, DVec2),
    Polygon(Vec<DVec2>),
    Point(DVec2, String),
}

impl Mark {
    fn points(&self) -> Vec<DVec2> {
        match self {
            Self::Pixel(corner) => vec![*corner, *corner + DVec2::ONE],
            Self::Segment(a, b) | Self::Arrow(a, b) | Self::Stick(a, b) => vec![*a, *b],
            Self::Polygon(points) => points.clone(),
            Self::Point(p, _) => vec![*p],
        }
    }
}

/// One of the two halves of a picture: marks, the later ones above the earlier.
#[derive(Clone, Debug)]
pub struct Panel {
    y_down: bool,
    marks: Vec<(Mark, Ink)>,
    not_drawn: Option<DVec2>,
}

impl Panel {
    /// Pixels: y runs down, and pixel (x, y) is the square from (x, y) to (x + 1, y + 1).
    #[must_use]
    pub fn pixels() -> Self {
        Self {
            y_down: true,
            marks: Vec::new(),
            not_drawn: None,
        }
    }

    /// The plane: y runs up.
    #[must_use]
    pub fn plane() -> Self {
        Self {
            y_down: false,
            ..Self::pixels()
        }
    }

    /// A cell with its centre.
    pub fn pixel(&mut self, x: i32, y: i32, ink: Ink) {
        self.mark(Mark::Pixel(DVec2::new(x.into(), y.into())), ink);
    }

    /// A line from `a` to `b`.
    pub fn segment(&mut self, a: DVec2, b: DVec2, ink: Ink) {
        self.mark(Mark::Segment(a, b), ink);
    }

    /// An arrow from `a` to `b`.
    pub fn arrow(&mut self, a: DVec2, b: DVec2, ink: Ink) {
        self.mark(Mark::Arrow(a, b), ink);
    }

    /// A thick line from `a` to `b` with a white border, so that it covers what was painted before.
    pub fn stick(&mut self, a: DVec2, b: DVec2, ink: Ink) {
        self.mark(Mark::Stick(a, b), ink);
    }

    /// A closed outline, lightly filled where the ink has areas.
    pub fn polygon(&mut self, points: &[DVec2], ink: Ink) {
        if !points.is_empty() {
            self.mark(Mark::Polygon(points.to_vec()), ink);
        }
    }

    /// The outline of a window with the corners `min` and `max`.
    pub fn window(&mut self, min: DVec2, max: DVec2) {
        let corners = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
        self.polygon(&corners, Ink::Ideal);
    }

    /// A point and its name, which may be empty.
    pub fn point(&mut self, p: DVec2, name: &str, ink: Ink) {
        self.mark(Mark::Point(p, name.to_owned()), ink);
    }

    /// What lies at ∞, or so far away that nothing else would be seen, is told below instead.
    fn mark(&mut self, mark: Mark, ink: Ink) {
        let far = |p: &DVec2| !p.is_finite() || p.abs().max_element() > 1e150;
        match mark.points().into_iter().find(far) {
            Some(p) => self.not_drawn = self.not_drawn.or(Some(p)),
            None => self.marks.push((mark, ink)),
        }
    }

    fn points(&self) -> impl Iterator<Item = DVec2> + Clone {
        self.marks.iter().flat_map(|(mark, _)| mark.points())
    }

    fn has(&self, ink: Ink) -> bool {
        self.marks.iter().any(|(_, other)| *other == ink)
    }
}

/// What was drawn, beside what is right.
///
/// It is a guard: when the test panics while it lives, it is written to `pictures/NAME-TEST.svg` in the current folder, and
/// a line after the test's message names the file.
#[must_use = "the picture is written only while it lives: let _picture = …"]
#[derive(Debug)]
pub struct Picture {
    yours: Panel,
    right: Panel,
    exercise: String,
}

impl Picture {
    /// Both halves are drawn to one scale.
    #[track_caller]
    pub fn beside(yours: Panel, right: Panel) -> Self {
        let file = Path::new(Location::caller().file());
        let exercise = file.file_stem().unwrap_or_default();
        Self {
            yours,
            right,
            exercise: exercise.to_string_lossy().into_owned(),
        }
    }

    /// The picture as SVG.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut svg = String::new();
        let frame = Frame::around(self.yours.points().chain(self.right.points()));
        let (width, height) = (2.0 * PANEL + 3.0 * MARGIN, frame.height + TOP + BOTTOM);
        let exercise = escape(&self.exercise);
        // Writing to a String cannot fail.
        let _ = write!(
            svg,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
             viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"sans-serif\" font-size=\"17\" fill=\"#161b21\" \
             stroke-linejoin=\"round\" stroke-linecap=\"round\">\n<title>{exercise}: yours beside what is right</title>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        );
        for (left, title, panel) in [
            (MARGIN, "yours", &self.yours),
            (PANEL + 2.0 * MARGIN, "right", &self.right),
        ] {
            let _ = writeln!(
                svg,
                "<text x=\"{left:.0}\" y=\"28\" font-weight=\"bold\">{title}</text>"
            );
            draw(&mut svg, panel, &frame, left);
        }
        let mut notes = Vec::new();
        if self.yours.has(Ink::Missing) {
            notes.push("? missing".to_owned());
        }
        if self.yours.has(Ink::Extra) {
            notes.push("× should not be there".to_owned());
        }
        for (whose, panel) in [("yours", &self.yours), ("right", &self.right)] {
            if let Some(p) = panel.not_drawn {
                notes.push(format!("{whose} has {}, which is not drawn", show_point(p)));
            }
        }
        let _ = write!(
            svg,
            "<text x=\"{MARGIN:.0}\" y=\"{:.0}\">{}</text>\n</svg>\n",
            height - 14.0,
            escape(&notes.join(" · ")),
        );
        svg
    }

    /// Writes the picture, whole or not at all; the path of the file.
    fn write(&self) -> std::io::Result<PathBuf> {
        // Rust's test programs, and the grader's, name the thread after the test: EXERCISE::TEST.
        let thread = std::thread::current();
        let test = thread.name().and_then(|name| name.rsplit("::").next());
        let name = format!("{}-{}", self.exercise, test.unwrap_or("test"));
        let dir = Path::new("pictures");
        let file = dir.join(format!("{name}.svg"));
        fs::create_dir_all(dir)?;
        let half = dir.join(format!(".{name}.{}.tmp", std::process::id()));
        fs::write(&half, self.svg())?;
        fs::rename(&half, &file)?;
        Ok(file)
    }
}

impl Drop for Picture {
    fn drop(&mut self) {
        if std::thread::panicking() {
            match self.write() {
                Ok(file) => {
                    // The same on every system.
                    let file = file.display().to_string().replace('\\', "/");
                    eprintln!("what you drew, beside what is right: {file}");
                }
                Err(error) => eprintln!("the picture of it cannot be written: {error}"),
            }
        }
    }
}

/// Width of a half, and the largest height.
const PANEL: f64 = 460.0;
const MARGIN: f64 = 40.0;
const TOP: f64 = 60.0;
const BOTTOM: f64 = 50.0;
/// A lattice of more lines than these is grey all over.
const MOST_LINES: f64 = 64.0;

/// Where the points of the plane lie in a half.
struct Frame {
    min: DVec2,
    max: DVec2,
    scale: f64,
    height: f64,
}

impl Frame {
    fn around(points: impl Iterator<Item = DVec2> + Clone) -> Self {
        let min = points.clone().reduce(DVec2::min).unwrap_or(DVec2::ZERO);
        let max = points.reduce(DVec2::max).unwrap_or(DVec2::ONE);
        // A single point has no size of its own.
        let size = (max - min).max_element();
        let size = if size > 0.0 { size } else { 1.0 };
        // Flat things get some room, and marks some air.
        let extent = (max - min).max(DVec2::splat(size / 5.0));
        let centre = min + (max - min) / 2.0;
        let (min, max) = (centre - 0.53 * extent, centre + 0.53 * extent);
        let extent = max - min;
        let scale = PANEL / extent.max_element();
        Self {
            min,
            max,
            scale,
            height: scale * extent.y,
        }
    }

    fn at(&self, p: DVec2, left: f64, y_down: bool) -> DVec2 {
        let across = PANEL / 2.0 - self.scale * (self.max.x - self.min.x) / 2.0;
        let down = if y_down {
            p.y - self.min.y
        } else {
            self.max.y - p.y
        };
        DVec2::new(
            left + across + self.scale * (p.x - self.min.x),
            TOP + self.scale * down,
        )
    }
}

fn draw(svg: &mut String, panel: &Panel, frame: &Frame, left: f64) {
    let at = |p: DVec2| frame.at(p, left, panel.y_down);
    if panel.y_down {
        lattice(svg, frame, &at);
    }
    for (mark, ink) in &panel.marks {
        let (line, area) = colours(*ink);
        let style = match ink {
            Ink::Missing | Ink::Faint => {
                format!("stroke=\"{line}\" stroke-width=\"1.6\" stroke-dasharray=\"5 4\"")
            }
            Ink::Ideal => format!("stroke=\"{line}\" stroke-width=\"1.6\""),
            _ => format!("stroke=\"{line}\" stroke-width=\"2.4\""),
        };
        let _ = match mark {
            Mark::Pixel(corner) => pixel(svg, *corner, *ink, frame.scale, &at, &style),
            Mark::Segment(a, b) => {
                let (a, b) = (at(*a), at(*b));
                writeln!(
                    svg,
                    "<path d=\"M{:.1} {:.1}L{:.1} {:.1}\" fill=\"none\" {style}/>",
                    a.x, a.y, b.x, b.y
                )
            }
            Mark::Stick(a, b) => {
                let (a, b) = (at(*a), at(*b));
                let path = format!("M{:.1} {:.1}L{:.1} {:.1}", a.x, a.y, b.x, b.y);
                writeln!(
                    svg,
                    "<path d=\"{path}\" stroke=\"#ffffff\" stroke-width=\"17\" stroke-linecap=\"butt\"/>\
                     <path d=\"{path}\" stroke=\"{line}\" stroke-width=\"9\" stroke-linecap=\"butt\"/>",
                )
            }
            Mark::Arrow(a, b) => {
                let (a, b) = (at(*a), at(*b));
                let along = (b - a).normalize_or_zero();
                let [p, q] = [1.0, -1.0].map(|side| b - 11.0 * along + side * 5.0 * along.perp());
                writeln!(
                    svg,
                    "<path d=\"M{:.1} {:.1}L{:.1} {:.1}M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}\" fill=\"none\" {style}/>",
                    a.x, a.y, b.x, b.y, p.x, p.y, b.x, b.y, q.x, q.y
                )
            }
            Mark::Polygon(points) => {
                let path: Vec<String> = points
                    .iter()
                    .map(|&p| format!("{:.1} {:.1}", at(p).x, at(p).y))
                    .collect();
                writeln!(
                    svg,
                    "<path d=\"M{}Z\" fill=\"{area}\" fill-opacity=\"0.5\" {style}/>",
                    path.join("L")
                )
            }
            Mark::Point(p, name) => point(svg, at(*p), name, *ink),
        };
    }
}

/// The lines between the cells, and numbers along the upper and the left border.
fn lattice(svg: &mut String, frame: &Frame, at: &impl Fn(DVec2) -> DVec2) {
    let (first, last) = (frame.min.ceil(), frame.max.floor());
    let count = (last - first).max_element();
    if count > MOST_LINES {
        return;
    }
    let step = if count > 24.0 { 5 } else { 1 };
    let mut path = String::new();
    let mut numbers = String::new();
    let mut number = |p: DVec2, value: i64, anchor: &str| {
        if value % step == 0 {
            let _ = write!(
                numbers,
                "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"12\" fill=\"#5a636d\" text-anchor=\"{anchor}\">{value}</text>",
                p.x, p.y
            );
        }
    };
    for x in first.x as i64..=last.x as i64 {
        let [a, b] = [first.y, last.y].map(|y| at(DVec2::new(x as f64, y)));
        let _ = write!(path, "M{:.1} {:.1}L{:.1} {:.1}", a.x, a.y, b.x, b.y);
        if (x as f64) < last.x {
            let middle = at(DVec2::new(x as f64 + 0.5, first.y));
            number(middle - DVec2::new(0.0, 5.0), x, "middle");
        }
    }
    for y in first.y as i64..=last.y as i64 {
        let [a, b] = [first.x, last.x].map(|x| at(DVec2::new(x, y as f64)));
        let _ = write!(path, "M{:.1} {:.1}L{:.1} {:.1}", a.x, a.y, b.x, b.y);
        if (y as f64) < last.y {
            let middle = at(DVec2::new(first.x, y as f64 + 0.5));
            number(middle + DVec2::new(-6.0, 4.0), y, "end");
        }
    }
    let _ = writeln!(
        svg,
        "<path d=\"{path}\" fill=\"none\" stroke=\"#d3d8de\"/>\n{numbers}"
    );
}

fn pixel(
    svg: &mut String,
    corner: DVec2,
    ink: Ink,
    scale: f64,
    at: &impl Fn(DVec2) -> DVec2,
    style: &str,
) -> std::fmt::Result {
    let (line, area) = colours(ink);
    let [p, q] = [corner, corner + DVec2::ONE].map(at);
    write!(
        svg,
        "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{scale:.1}\" height=\"{scale:.1}\" fill=\"{area}\" {style}/>",
        p.x.min(q.x),
        p.y.min(q.y),
    )?;
    let centre = (p + q) / 2.0;
    let letter = match ink {
        Ink::Missing => Some('?'),
        Ink::Extra => Some('×'),
        Ink::Shade(k) => char::from_u32('A' as u32 + (k % 6) as u32),
        _ => None,
    };
    match letter {
        Some(letter) if scale >= 9.0 => writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"{:.0}\" text-anchor=\"middle\">{letter}</text>",
            centre.x,
            centre.y + 0.25 * scale.min(24.0),
            (0.7 * scale).min(17.0),
        ),
        _ if scale >= 9.0 => writeln!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"2\" fill=\"{line}\"/>",
            centre.x, centre.y
        ),
        _ => writeln!(svg),
    }
}

fn point(svg: &mut String, p: DVec2, name: &str, ink: Ink) -> std::fmt::Result {
    let (line, _) = colours(ink);
    match ink {
        Ink::Missing => writeln!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"6\" fill=\"#ffffff\" stroke=\"{line}\" stroke-width=\"2\" \
             stroke-dasharray=\"3 2\"/>",
            p.x, p.y
        )?,
        Ink::Extra => writeln!(
            svg,
            "<path d=\"M{:.1} {:.1}l10 10m0 -10l-10 10\" stroke=\"{line}\" stroke-width=\"2.4\"/>",
            p.x - 5.0,
            p.y - 5.0
        )?,
        Ink::Light => {
            write!(svg, "<path d=\"")?;
            for k in 0..8 {
                let ray = DVec2::from_angle(f64::from(k) * std::f64::consts::FRAC_PI_4);
                let (a, b) = (p + 9.0 * ray, p + 14.0 * ray);
                write!(svg, "M{:.1} {:.1}L{:.1} {:.1}", a.x, a.y, b.x, b.y)?;
            }
            writeln!(
                svg,
                "\" stroke=\"{line}\" stroke-width=\"2\"/><circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"6\" fill=\"{line}\"/>",
                p.x, p.y
            )?;
        }
        _ => writeln!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"4.5\" fill=\"{line}\"/>",
            p.x, p.y
        )?,
    }
    if name.is_empty() {
        return Ok(());
    }
    writeln!(
        svg,
        "<text x=\"{:.1}\" y=\"{:.1}\" stroke=\"#ffffff\" stroke-width=\"4\" paint-order=\"stroke\">{}</text>",
        p.x + 9.0,
        p.y - 8.0,
        escape(name),
    )
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step() -> Picture {
        let mut yours = Panel::pixels();
        yours.pixel(0, 0, Ink::Right);
        yours.pixel(1, 0, Ink::Extra);
        yours.pixel(1, 1, Ink::Missing);
        let mut right = Panel::pixels();
        right.pixel(0, 0, Ink::Right);
        right.pixel(1, 1, Ink::Right);
        for panel in [&mut yours, &mut right] {
            panel.segment(DVec2::splat(0.5), DVec2::splat(1.5), Ink::Ideal);
        }
        Picture::beside(yours, right)
    }

    #[test]
    fn pixels_are_cells_of_one_size_in_both_halves() {
        let svg = step().svg();
        let cells: Vec<&str> = svg
            .match_indices("<rect x=")
            .map(|(at, _)| &svg[at..])
            .collect();
        assert_eq!(cells.len(), 5);
        let size = |cell: &str| cell.split('"').nth(5).map(str::to_owned);
        assert!(
            cells.iter().all(|cell| size(cell) == size(cells[0])),
            "{svg}"
        );
        assert!(svg.contains(">?</text>") && svg.contains(">×</text>"));
        assert!(svg.contains("? missing · × should not be there"));
        // Two columns and two rows, both numbered, in both halves.
        assert_eq!(svg.matches(">1</text>").count(), 4);
    }

    #[test]
    fn the_plane_runs_up() {
        let mut panel = Panel::plane();
        panel.point(DVec2::ZERO, "low", Ink::Right);
        panel.point(DVec2::Y, "<high>", Ink::Light);
        let svg = Picture::beside(panel, Panel::plane()).svg();
        let y = |name: &str| {
            let before = svg.split(name).next().unwrap_or_default();
            let at = before.rsplit(" y=\"").next().unwrap_or_default();
            at.split('"').next().and_then(|y| y.parse::<f64>().ok())
        };
        assert!(y(">low<") > y("&lt;high&gt;"), "{svg}");
    }

    #[test]
    fn nothing_and_what_is_no_number_have_a_picture() {
        for p in [
            DVec2::NAN,
            DVec2::new(f64::INFINITY, 0.0),
            DVec2::splat(1e300),
            DVec2::splat(1e-300),
            DVec2::ZERO,
        ] {
            let mut panel = Panel::plane();
            panel.point(p, "p", Ink::Right);
            panel.segment(DVec2::ZERO, p, Ink::Ideal);
            let svg = Picture::beside(panel, Panel::plane()).svg();
            let drawn = svg
                .replace("yours has (NaN, NaN)", "")
                .replace("(inf, 0)", "");
            assert!(!drawn.contains("NaN") && !drawn.contains("inf"), "{svg}");
        }
        assert!(
            Picture::beside(Panel::pixels(), Panel::pixels())
                .svg()
                .ends_with("</svg>\n")
        );
    }

    #[test]
    fn a_failing_test_writes_it_and_a_passing_one_does_not() {
        let file = Path::new("pictures/picture-a_test_of_the_picture.svg");
        let run = |fails: bool| {
            std::thread::Builder::new()
                .name("picture::a_test_of_the_picture".to_owned())
                .spawn(move || {
                    let _picture = step();
                    assert!(!fails, "on purpose");
                })
                .map(std::thread::JoinHandle::join)
        };
        assert!(run(false).is_ok_and(|ended| ended.is_ok()) && !file.exists());
        assert!(run(true).is_ok_and(|ended| ended.is_err()));
        assert_eq!(fs::read_to_string(file).ok(), Some(step().svg()));
        assert!(fs::remove_file(file).is_ok());
        // Other tests of this crate may have drawn beside it.
        let _ = fs::remove_dir("pictures");
    }
}
