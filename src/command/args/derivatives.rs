use crate::command::names::{outcomes, usual, variables};
use crate::parameters::Parameter;
use crate::{Outcome, Result, Setup};

/// The outcomes and the parameters of derivatives.
#[derive(clap::Args)]
pub struct DerivativeArgs {
    /// The outcomes, separated by commas.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    of: Vec<String>,

    /// The parameters, separated by commas; "all" for every one that has a value in this setup.
    /// Without: loft and attack angle, or the launch conditions if they are given.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    wrt: Vec<String>,
}

impl DerivativeArgs {
    /// The outcomes.
    ///
    /// # Errors
    /// For an unknown name.
    pub fn outcomes(&self) -> Result<Vec<Outcome>> {
        outcomes(&self.of)
    }

    /// The parameters by which the outcomes `of` are differentiated.
    ///
    /// # Errors
    /// For an unknown name, and for a parameter without a value.
    pub fn variables(&self, setup: &Setup<f64>, of: &[Outcome]) -> Result<Vec<&'static Parameter>> {
        if self.wrt.is_empty() {
            return usual(setup);
        }
        variables(setup, &self.wrt, of)
    }
}
