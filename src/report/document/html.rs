use super::{Block, Document};
use crate::error::Result;
use crate::report::plot::{Look, dark_rules, figure_svg};
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// How a page looks: to be read on a phone, on a screen by day or night, and in print.
const STYLE: &str = "\
:root{color-scheme:light dark}\
body{font:16px/1.5 system-ui,sans-serif;max-width:62rem;margin:auto;padding:1rem}\
.wide{overflow-x:auto}\
table{border-collapse:collapse;font-size:.875rem}\
td,th{padding:.2rem .6rem;border-bottom:1px solid #8884;white-space:nowrap;text-align:right}\
td:last-child,th:last-child{text-align:left;white-space:normal;min-width:10rem}\
figure{margin:1rem 0}\
svg{max-width:100%;height:auto}\
@media print{body{max-width:none;font-size:10pt}table{font-size:7pt}td,th{white-space:normal}}";

impl Document {
    /// As one page of HTML, complete in itself: the figures are in it, and nothing is fetched.
    ///
    /// # Errors
    /// As [`figure_svg`].
    pub fn html(&self, look: &Look) -> Result<String> {
        let blocks = self.blocks.iter().map(|block| block_html(block, look)).collect::<Result<Vec<_>>>()?;
        let dark = format!("@media screen and (prefers-color-scheme:dark){{\n{}}}", dark_rules("svg"));
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width,initial-scale=1";
                    title { (self.title()) }
                    style { (PreEscaped(STYLE)) (PreEscaped(dark)) }
                }
                body { @for block in &blocks { (block) "\n" } }
            }
        };
        Ok(page.into_string())
    }
}

fn block_html(block: &Block, look: &Look) -> Result<Markup> {
    Ok(match block {
        Block::Title(text) => html! { h1 { (text) } },
        Block::Heading(text) => html! { h2 { (text) } },
        Block::Paragraph(text) => html! { p { (text) } },
        Block::Table { head, rows } => html! {
            div.wide {
                table {
                    thead { tr { @for name in head { th { (name) } } } }
                    tbody { @for row in rows { tr { @for cell in row { td { (cell) } } } } }
                }
            }
        },
        Block::Figure(figure) => {
            let svg = figure_svg(figure, look)?;
            html! { figure { (PreEscaped(svg)) figcaption { (figure.note) } } }
        }
    })
}
