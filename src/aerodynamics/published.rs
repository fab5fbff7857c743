/// Where a law comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Published {
    /// Who published it, or made it from what others published.
    pub authors: &'static str,
    /// The year of the publication, if it is of one.
    pub year: Option<u16>,
    /// The ball it is of, where the source says which.
    pub ball: Option<&'static str>,
    /// The publication, and how its numbers came here.
    pub source: &'static str,
}
