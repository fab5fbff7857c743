//! Checks of lists of parameters, whose values are given beside a setup.

use super::air::follows_from;
use super::declare::Parameter;
use super::setup::NO_CLUB;
use super::table::Setup;
use crate::error::{Error, Result};
use crate::repeated::first_repeated;

impl Setup<f64> {
    /// Checks a setup with the values of `columns` given beside it, and with derivatives by `wrt`.
    /// The columns may complete a launch, the weather or the wind of the setup.
    ///
    /// # Errors
    /// The errors of [`validate`](Self::validate), of [`column`](Self::column) for `columns`, and
    /// of [`variable`](Self::variable) for `wrt`; [`Error::OtherLaw`] for a coefficient of another
    /// law; [`Error::NotVariable`] for a parameter of `wrt` that follows from a column, and for a
    /// parameter of the strike if the launch is given; [`Error::Together`] if `columns` or `wrt`
    /// repeats a parameter.
    pub(crate) fn check_lists(
        &self,
        columns: &[&'static Parameter],
        wrt: &[&'static Parameter],
    ) -> Result<()> {
        self.validate_values()?;
        refuse_twice(columns, "the parameters with values")?;
        for parameter in columns {
            self.check_column(parameter)?;
        }
        for parameter in wrt.iter().filter(|wrt| !columns.contains(wrt)) {
            self.check_variable(parameter)?;
            let mut columns = columns.iter();
            if let Some(by) = columns.find(|column| follows_from(parameter.name, column.name)) {
                return Err(Error::NotVariable {
                    name: parameter.name.into(),
                    reason: format!("it follows from {}, which each row gives", by.name),
                });
            }
        }
        refuse_twice(wrt, "the parameters to differentiate by")?;
        let names: Vec<_> = columns.iter().map(|parameter| parameter.name).collect();
        self.check_launch(&names)?;
        self.check_air(&names)?;
        let is_launched =
            self.launch.is_given() || columns.iter().any(|parameter| parameter.is_of_launch());
        let mut all = columns.iter().chain(wrt);
        match all.find(|parameter| is_launched && parameter.is_of_strike()) {
            Some(of_club) => Err(Error::NotVariable {
                name: of_club.name.into(),
                reason: NO_CLUB.into(),
            }),
            None => Ok(()),
        }
    }
}

/// Refuses a parameter that is given twice. `list` names the list in the message.
fn refuse_twice(parameters: &[&'static Parameter], list: &str) -> Result<()> {
    let Some([_, again]) = first_repeated(parameters, |a, b| a == b) else {
        return Ok(());
    };
    Err(Error::Together {
        given: format!("{} is given twice among {list}", parameters[again]),
        reason: "name it once".into(),
    })
}
