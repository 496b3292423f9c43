//! `index.html`: all figures on one page that opens from disk, without server or network.

use core::fmt::Write as _;

use crate::colour::Role;
use crate::figure::{Figure, Inputs};
use crate::style::{Format, Style};
use crate::svg::{LICENCE_URL, escaped};
use crate::words::words;

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
}

/// The page for `figures` written in `formats` beside it.
pub fn gallery(figures: &[&Figure], style: &Style, inputs: &Inputs, formats: &[Format]) -> String {
    let language = style.language;
    let colour = |role: Role| format!("#{:06x}", role.rgb(style.theme));
    let title = escaped(TITLE.text(language));
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>Ombra · {title}</title>\n<style>\n\
         body {{ margin: 2rem; background: {}; color: {}; font: 1rem/1.4 'DejaVu Sans', Verdana, sans-serif }}\n\
         main {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr)); gap: 2rem }}\n\
         figure {{ margin: 0 }}\nimg {{ width: 100%; height: auto; border: 1px solid {} }}\n\
         a {{ color: inherit }}\nfigcaption b {{ display: block }}\n</style>\n</head>\n<body>\n\
         <h1>Ombra · {title}</h1>\n<p><a href=\"{LICENCE_URL}\">{}</a></p>\n",
        colour(Role::Paper),
        colour(Role::Text),
        colour(Role::Grid),
        escaped(LICENCE.text(language)),
    );
    let mut lecture = "";
    for figure in figures {
        if figure.lecture() != lecture {
            if !lecture.is_empty() {
                page.push_str("</main>\n");
            }
            lecture = figure.lecture();
            let _ = writeln!(page, "<h2>{lecture}</h2>\n<main>");
        }
        let summary = escaped(figure.summary(inputs, language));
        let best = formats
            .iter()
            .find(|&&format| format == Format::Svg)
            .or(formats.iter().find(|&&format| format == Format::Png));
        let _ = writeln!(page, "<figure>");
        if let Some(format) = best {
            let file = format!("{}.{format}", figure.id);
            let _ = writeln!(
                page,
                "<a href=\"{file}\"><img src=\"{file}\" alt=\"{summary}\" width=\"{}\" height=\"{}\" loading=\"lazy\"></a>",
                style.size.width(),
                style.size.height()
            );
        }
        let links: Vec<String> = formats
            .iter()
            .map(|format| format!("<a href=\"{}.{format}\">{format}</a>", figure.id))
            .collect();
        let _ = writeln!(
            page,
            "<figcaption><b>{}</b>{summary} ({})</figcaption>\n</figure>",
            figure.id,
            links.join(", ")
        );
    }
    if !lecture.is_empty() {
        page.push_str("</main>\n");
    }
    page.push_str("</body>\n</html>\n");
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::course::figures;
    use crate::style::Language;

    #[test]
    fn every_figure_is_linked_in_every_format_and_nothing_comes_from_the_network() {
        let all: Vec<&Figure> = figures().iter().collect();
        for &language in Language::ALL {
            let style = Style {
                language,
                ..Style::default()
            };
            let page = gallery(&all, &style, &Inputs::default(), Format::ALL);
            for figure in &all {
                for format in Format::ALL {
                    assert!(page.contains(&format!("href=\"{}.{format}\"", figure.id)));
                }
                assert!(page.contains(&escaped(figure.summary(&Inputs::default(), language))));
            }
            // No browser shows a PDF as a picture: it is a link, and the only one if it is the only format.
            assert!(!page.contains(".pdf\"><img"));
            let only = gallery(&all, &style, &Inputs::default(), &[Format::Pdf]);
            assert!(!only.contains("<img") && only.contains(".pdf\">pdf</a>"));
            // The licence's address is a link to follow, not a thing to load.
            let addresses = page.matches("http").count();
            assert_eq!(addresses, page.matches(LICENCE_URL).count());
            assert!(
                !page.contains("src=\"http")
                    && !page.contains("<script")
                    && !page.contains("@import")
            );
            assert_eq!(
                page.matches("<main>").count(),
                page.matches("</main>").count()
            );
        }
    }
}
