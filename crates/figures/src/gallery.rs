//! `index.html`: the figures that lie in a folder on one page that opens from disk, without server or network; and the
//! names of their files.
//!
//! There is no list of them beside the figures: a file's name says figure, language, theme and size, and an SVG its own
//! title and command. So the page shows what is there, also after files were copied in or deleted by hand.

mod folder;
mod names;

use core::fmt::Write as _;

pub(crate) use folder::with_command;
pub use folder::{Shown, lectures, shown};
pub use names::{LONGEST_VARIANT, Named, address, command, file_stem, read_name, variant};

use crate::colour::Role;
use crate::style::{Format, Language, Theme};
use crate::svg::{LICENCE_URL, escaped};
use crate::words::{Word, words};

words! {
    /// Heading of the gallery.
    TITLE {
        en: "Figures",
        it: "Figure",
        cs: "Obrázky",
        hr: "Slike",
    }

    /// The licence of the figures, said in the gallery.
    LICENCE {
        en: "Free to use in slides (CC0 1.0).",
        it: "Di libero uso nelle slide (CC0 1.0).",
        cs: "Volně k použití v prezentacích (CC0 1.0).",
        hr: "Slobodno za upotrebu u prezentacijama (CC0 1.0).",
    }

    /// The lecture `math`.
    MATH {
        en: "Mathematics",
        it: "Matematica",
        cs: "Matematika",
        hr: "Matematika",
    }

    /// The lecture `raster`.
    RASTER {
        en: "Rasterization",
        it: "Rasterizzazione",
        cs: "Rasterizace",
        hr: "Rasterizacija",
    }

    /// The lecture `clip`.
    CLIP {
        en: "Clipping",
        it: "Clipping",
        cs: "Ořezávání",
        hr: "Odsijecanje",
    }

    /// The lecture `sampling`.
    SAMPLING {
        en: "Sampling",
        it: "Campionamento",
        cs: "Vzorkování",
        hr: "Uzorkovanje",
    }

    /// The lecture `shading`.
    SHADING {
        en: "Shading",
        it: "Shading",
        cs: "Stínování",
        hr: "Sjenčanje",
    }

    /// The lecture `hsr`.
    HSR {
        en: "Hidden surfaces",
        it: "Superfici nascoste",
        cs: "Skryté plochy",
        hr: "Skrivene površine",
    }

    /// The lecture `shadows`.
    SHADOWS {
        en: "Shadows",
        it: "Ombre",
        cs: "Stíny",
        hr: "Sjene",
    }
}

/// The title of a lecture; a lecture without one goes by its own name.
pub fn lecture_title(lecture: &'static str) -> Word {
    match lecture {
        "math" => MATH,
        "raster" => RASTER,
        "clip" => CLIP,
        "sampling" => SAMPLING,
        "shading" => SHADING,
        "hsr" => HSR,
        "shadows" => SHADOWS,
        _ => Word::english(lecture),
    }
}

/// The page for what is `shown`, its headings in `language`; light or dark as the reader's system is.
pub fn gallery(shown: &[Shown], language: Language) -> String {
    let mut page = head(language);
    let in_order = shown.chunk_by(|a, b| a.named.figure.lecture() == b.named.figure.lecture());
    let lectures: Vec<(&str, &str, &[Shown])> = in_order
        .filter_map(|pictures| {
            let lecture = pictures.first()?.named.figure.lecture();
            Some((lecture, lecture_title(lecture).text(language), pictures))
        })
        .collect();
    page.push_str("<nav>\n");
    for (lecture, title, _) in &lectures {
        let _ = writeln!(page, "<a href=\"#{lecture}\">{}</a>", escaped(title));
    }
    page.push_str("</nav>\n<main>\n");
    for (lecture, title, pictures) in &lectures {
        let title = escaped(title);
        let _ = writeln!(
            page,
            "<section id=\"{lecture}\">\n<h2>{title}</h2>\n<div class=\"figures\">"
        );
        for picture in *pictures {
            card(&mut page, picture, language);
        }
        page.push_str("</div>\n</section>\n");
    }
    page.push_str("</main>\n</body>\n</html>\n");
    page
}

fn head(language: Language) -> String {
    let title = escaped(TITLE.text(language));
    let colours = |theme: Theme| {
        let colour = |role: Role| format!("#{:06x}", role.rgb(theme));
        format!(
            "--paper: {}; --text: {}; --line: {}",
            colour(Role::Paper),
            colour(Role::Text),
            colour(Role::Grid)
        )
    };
    let (light, dark) = (colours(Theme::Light), colours(Theme::Dark));
    let paper = |theme: Theme| format!("#{:06x}", Role::Paper.rgb(theme));
    format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>Ombra · {title}</title>\n\
         <style>\n\
         :root {{ color-scheme: light dark; {light} }}\n\
         @media (prefers-color-scheme: dark) {{ :root {{ {dark} }} }}\n\
         body {{ margin: 0; padding: 1rem clamp(1rem, 3vw, 3rem); background: var(--paper); color: var(--text); \
         font: 1rem/1.4 'DejaVu Sans', Verdana, sans-serif; overflow-wrap: anywhere }}\n\
         nav {{ display: flex; flex-wrap: wrap; gap: .5rem 1.5rem }}\n\
         .figures {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr)); \
         gap: 2rem 1.5rem }}\n\
         figure {{ margin: 0; min-width: 0 }}\n\
         img {{ box-sizing: border-box; display: block; width: 100%; height: auto; aspect-ratio: 16 / 9; \
         object-fit: contain; border: 1px solid var(--line) }}\n\
         img.light {{ background: {} }}\nimg.dark {{ background: {} }}\n\
         a {{ color: inherit }}\nh3 {{ margin: .5rem 0 0; font-size: 1rem }}\np {{ margin: .25rem 0 }}\n\
         code {{ display: block; padding: .4rem .6rem; border: 1px solid var(--line); user-select: all; \
         font: .875rem/1.4 'DejaVu Sans Mono', Consolas, monospace }}\n\
         </style>\n</head>\n<body>\n<h1>Ombra · {title}</h1>\n<p><a href=\"{LICENCE_URL}\">{}</a></p>\n",
        paper(Theme::Light),
        paper(Theme::Dark),
        escaped(LICENCE.text(language)),
    )
}

/// One picture, what it shows, the command and its files.
fn card(page: &mut String, picture: &Shown, language: Language) {
    let Shown { named, formats, .. } = picture;
    let (style, stem) = (named.style, named.stem());
    let file = |format: Format| names::link(&format!("{stem}.{format}"));
    let summary = escaped(&picture.title);
    // A browser shows both of these; whatever else is there is linked.
    let image = [Format::Svg, Format::Png]
        .into_iter()
        .find(|format| formats.contains(format));
    page.push_str("<figure>\n");
    if let Some(format) = image {
        let _ = writeln!(
            page,
            "<a href=\"{0}\"><img class=\"{1}\" src=\"{0}\" alt=\"{summary}\" width=\"{2}\" height=\"{3}\" \
             loading=\"lazy\"/></a>",
            file(format),
            style.theme,
            style.size.width(),
            style.size.height()
        );
    }
    let name = escaped(stem.split_once('/').map_or(stem.as_str(), |(_, name)| name));
    let said = if style.language == language {
        String::new()
    } else {
        format!(" lang=\"{}\"", style.language)
    };
    let _ = writeln!(
        page,
        "<figcaption>\n<h3>{name}</h3>\n<p{said}>{summary}</p>"
    );
    if let Some(command) = &picture.command {
        let _ = writeln!(page, "<code>{}</code>", escaped(command));
    }
    let links: Vec<String> = formats
        .iter()
        .map(|&format| format!("<a href=\"{}\">{format}</a>", file(format)))
        .collect();
    let _ = writeln!(
        page,
        "<p>{}</p>\n</figcaption>\n</figure>",
        links.join(" · ")
    );
}
