use super::{Document, DocumentBlock, DocumentTable};
use crate::error::{Error, Result};
use crate::report::frame::{TextFile, chosen, page, picture_files, pictures, scrolled};
use crate::report::in_both::InBoth;
use crate::report::plot::Figure;
use crate::units::System;
use maud::{Markup, html};

/// A document as an HTML page, with separate files for the pictures and the data of its figures.
/// Returns all files, `index.html` first. The page has a switch of units, and opens in the units of
/// `system`. Data files are in SI, but values in names of layers are in the units of `system`.
///
/// # Errors
/// The errors of [`figure_svg`](crate::report::plot::figure_svg) and
/// [`figure_csv`](crate::report::plot::figure_csv).
pub fn document_files(documents: &InBoth<Document>, system: System) -> Result<Vec<TextFile>> {
    let title = &documents.get(system).title;
    let header = html! { h1 { (chosen(&documents.metric.title, &documents.us.title)) } };
    let mut files = vec![TextFile {
        name: "index.html".into(),
        text: page(title, &header, &content(documents, false)?, None, system),
    }];
    let figures: Vec<_> = blocks(documents).iter().filter_map(figure).collect();
    files.extend(picture_files(&figures, system)?);
    Ok(files)
}

/// The blocks of a document, each in both systems of units.
fn blocks(documents: &InBoth<Document>) -> Vec<InBoth<&DocumentBlock>> {
    let blocks = documents.metric.blocks().zip(documents.us.blocks());
    blocks.map(|(metric, us)| InBoth { metric, us }).collect()
}

/// The blocks of a document. With `is_stacked`, a narrow page shows each cell of a table on a line
/// of its own, after the head of its column.
///
/// # Errors
/// The errors of [`figure_svg`](crate::report::plot::figure_svg). [`Error::Output`] if the kinds of
/// a block differ between the systems of units, which no report causes.
pub(in crate::report) fn content(documents: &InBoth<Document>, is_stacked: bool) -> Result<Markup> {
    let mut parts = Parts {
        labels: vec![],
        about: documents.us.title.clone(),
        is_stacked,
    };
    // put consecutive figures side by side
    let all = blocks(documents)
        .chunk_by(|a, b| figure(a).is_some() && figure(b).is_some())
        .map(|blocks| parts.part(blocks))
        .collect::<Result<Vec<_>>>()?;
    Ok(html! { @for part in all { (part) "\n" } })
}

/// The figure of a block; `None` unless the block is a figure in both systems of units.
fn figure<'a>(block: &InBoth<&'a DocumentBlock>) -> Option<InBoth<&'a Figure>> {
    match (block.metric, block.us) {
        (DocumentBlock::Figure(metric), DocumentBlock::Figure(us)) => Some(InBoth {
            metric: metric.as_ref(),
            us: us.as_ref(),
        }),
        _ => None,
    }
}

/// Converts the blocks of a page in order. `about` is the label of the next table: the title of the
/// page, or the last heading, caption or short paragraph.
struct Parts {
    labels: Vec<String>,
    about: String,
    is_stacked: bool,
}

impl Parts {
    /// Converts one block or several consecutive figures.
    ///
    /// # Errors
    /// The errors of [`content`].
    fn part(&mut self, blocks: &[InBoth<&DocumentBlock>]) -> Result<Markup> {
        Ok(match blocks {
            [
                InBoth {
                    metric: DocumentBlock::Heading(metric),
                    us: DocumentBlock::Heading(us),
                },
            ] => {
                self.about.clone_from(us);
                html! { h2 { (chosen(metric, us)) } }
            }
            [
                InBoth {
                    metric: DocumentBlock::Paragraph(metric),
                    us: DocumentBlock::Paragraph(us),
                },
            ] => {
                // a short line above a table is its label
                if us.ends_with([':', '.']) && us.chars().count() < 80 {
                    self.about = us.trim_end_matches([':', '.']).into();
                }
                html! { p { (chosen(metric, us)) } }
            }
            [
                InBoth {
                    metric: DocumentBlock::List(metric),
                    us: DocumentBlock::List(us),
                },
            ] => {
                html! {
                    ul { @for (metric, us) in metric.iter().zip(us) { li { (chosen(&metric.text, &us.text)) } } }
                }
            }
            [
                InBoth {
                    metric: DocumentBlock::Table(metric),
                    us: DocumentBlock::Table(us),
                },
            ] => {
                if !us.caption.is_empty() {
                    self.about = us.caption.trim_end_matches([':', '.']).into();
                }
                html! {
                    @if !us.caption.is_empty() { p { (chosen(&metric.caption, &us.caption)) } }
                    (scrolled(&self.label(), table(metric, us, self.is_stacked)))
                    @for (metric, us) in metric.notes().zip(us.notes()) { p { (chosen(metric, us)) } }
                }
            }
            figures => {
                let Some(figures) = figures.iter().map(figure).collect::<Option<Vec<_>>>() else {
                    let reason = "the metric and the US document have different blocks; this is a fault of longdrive";
                    return Err(Error::Output(std::io::Error::other(reason)));
                };
                pictures(&figures)?
            }
        })
    }

    /// A unique label of a table.
    fn label(&mut self) -> String {
        let count = self
            .labels
            .iter()
            .filter(|label| **label == self.about)
            .count();
        self.labels.push(self.about.clone());
        if count == 0 {
            self.about.clone()
        } else {
            format!("{} ({})", self.about, count + 1)
        }
    }
}

fn table(metric: &DocumentTable, us: &DocumentTable, is_stacked: bool) -> Markup {
    // the cells of these columns name the row, so they need no head on a narrow page
    let is_key = |column: usize| column < us.key_columns;
    let class = |column: usize| {
        let kind = if us.is_right[column] {
            "number"
        } else {
            "words"
        };
        if is_stacked && is_key(column) {
            format!("{kind} key")
        } else {
            kind.into()
        }
    };
    let heads = metric.head.iter().zip(&us.head);
    let heads: Vec<Markup> = heads.map(|(metric, us)| chosen(metric, us)).collect();
    let has_label = |column: usize| is_stacked && !is_key(column) && !heads[column].0.is_empty();
    html! {
        table class=[is_stacked.then_some("stacked")] {
            thead { tr {
                @for (column, head) in heads.iter().enumerate() {
                    @if head.0.is_empty() { td {} } @else { th class=(class(column)) scope="col" { (head) } }
                }
            } }
            tbody {
                @for (metric, us) in metric.rows.iter().zip(&us.rows) {
                    tr {
                        @for (column, (metric, us)) in metric.iter().zip(us).enumerate() {
                            td class=(class(column)) {
                                @if has_label(column) { span.label { (heads[column]) } }
                                (chosen(metric, us))
                            }
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Document, DocumentTable, InBoth, document_files};
    use crate::units::System;

    #[test]
    fn a_table_before_any_heading_has_the_title_as_its_label() {
        let mut document = Document {
            title: "Losses".into(),
            ..Document::default()
        };
        for _ in 0..2 {
            document.add(DocumentTable::new(["n"], [vec!["1".into()]]).right([0]));
        }
        let files = document_files(&InBoth::of(|_| document.clone()), System::Us).unwrap();
        let page = &files[0].text;
        for label in ["\"Losses\"", "\"Losses (2)\""] {
            assert!(page.contains(&format!("aria-label={label}")), "{page}");
        }
    }
}
