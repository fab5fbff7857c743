/// Source of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Published {
    /// Authors of the publication, or of the fit to published data.
    pub authors: &'static str,
    /// Year of the publication.
    pub year: Option<u16>,
    /// The measured ball, if the source names it.
    pub ball: Option<&'static str>,
    /// The publication, and how its numbers were obtained.
    pub source: &'static str,
}
