/// How far a differentiation goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Values.
    Value,
    /// Values and gradients.
    First,
    /// Values, gradients and Hessians.
    Second,
}

/// Which second derivatives are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pairs {
    /// All of them.
    All,
    /// Those that the last variable takes part in.
    WithLast,
}
