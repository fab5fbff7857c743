use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::repeated::first_repeated;
use crate::study::uncertainty::Uncertain;
use crate::units::{Message, counted};

/// Variation of a golfer's swings.
#[derive(Clone, Debug, PartialEq)]
pub enum Swings {
    /// Swings described by distributions of parameters.
    Distributed {
        /// The parameters that vary, with their distributions.
        inputs: Vec<Uncertain>,
        /// Lower triangular Cholesky factor L: L Lᵀ is the correlation matrix of the normal scores
        /// of `inputs` (see [`Correlation`]).
        factor: Vec<Vec<f64>>,
    },
    /// Recorded swings with equal probability.
    Recorded {
        /// The parameters that were recorded.
        parameters: Vec<&'static Parameter>,
        /// Values of the parameters, SI, a row for each swing.
        rows: Vec<Vec<f64>>,
        /// Remarks on ignored columns of the table; empty without a table.
        remarks: Vec<Message>,
    },
}

/// Correlation of the normal scores of two parameters (a Gaussian copula). The normal score of a
/// value with cumulative probability p is the standard normal quantile of p. For normal
/// distributions the correlation of the scores is the correlation of the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// The two parameters.
    pub between: [&'static Parameter; 2],
    /// Correlation coefficient, from −1 to 1.
    pub coefficient: f64,
}

impl Correlation {
    /// Reads `NAME,NAME=COEFFICIENT`.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for text that is not a correlation; the errors of [`Setup::column`]
    /// and [`Correlation::new`].
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let unreadable =
            |source: String| Error::unreadable(format!("the correlation {}", text.trim()), source);
        let how = "write NAME,NAME=COEFFICIENT, for example swing.path,swing.face_angle=0.6";
        let (names, coefficient) = text.split_once('=').ok_or_else(|| unreadable(how.into()))?;
        let (one, other) = names
            .split_once(',')
            .ok_or_else(|| unreadable(how.into()))?;
        let coefficient = coefficient
            .trim()
            .parse()
            .map_err(|_| unreadable(format!("'{}' is not a number; {how}", coefficient.trim())))?;
        Self::new(
            [setup.column(one.trim())?, setup.column(other.trim())?],
            coefficient,
        )
    }

    /// The correlation of two parameters.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a coefficient outside −1 to 1, and for a correlation of a
    /// parameter with itself.
    pub fn new(between: [&'static Parameter; 2], coefficient: f64) -> Result<Self> {
        let [one, other] = between.map(|parameter| parameter.name);
        let refuse = |source: String| {
            Error::unreadable(format!("the correlation of {one} and {other}"), source)
        };
        if one == other {
            return Err(refuse(
                "a parameter cannot be correlated with itself; name two".into(),
            ));
        }
        if !(-1.0..=1.0).contains(&coefficient) {
            return Err(refuse(format!("{coefficient} is outside of -1 to 1")));
        }
        Ok(Self {
            between,
            coefficient,
        })
    }
}

fn correlation_matrix(inputs: &[Uncertain], correlations: &[Correlation]) -> Result<Vec<Vec<f64>>> {
    let n = inputs.len();
    let mut matrix: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect())
        .collect();
    for (k, correlation) in correlations.iter().enumerate() {
        let [one, other] = correlation.between;
        let unreadable = |source: String| {
            Error::unreadable(
                format!("the correlation {},{}", one.name, other.name),
                source,
            )
        };
        let place = |parameter: &'static Parameter| {
            inputs
                .iter()
                .position(|input| input.parameter == parameter)
                .ok_or_else(|| {
                    unreadable(format!(
                        "{} has no distribution; give it one, or leave the correlation out",
                        parameter.name
                    ))
                })
        };
        let (i, j) = (place(one)?, place(other)?);
        let is_of_these =
            |before: &Correlation| [[one, other], [other, one]].contains(&before.between);
        if correlations[..k].iter().any(is_of_these) {
            return Err(unreadable("it is given twice; keep one".into()));
        }
        matrix[i][j] = correlation.coefficient;
        matrix[j][i] = correlation.coefficient;
    }
    Ok(matrix)
}

impl Swings {
    /// Swings described by distributions and correlations. A correlation that is not given is 0.
    ///
    /// # Errors
    /// [`Error::Nothing`] without a distribution; [`Error::Unreadable`] for a parameter given
    /// twice, for a correlation of a parameter without a distribution, and for a correlation matrix
    /// that is not positive semidefinite.
    pub fn distributed(inputs: Vec<Uncertain>, correlations: &[Correlation]) -> Result<Self> {
        if inputs.is_empty() {
            return Err(Error::Nothing {
                doing: "distribute",
                what: "parameter",
            });
        }
        if let Some([_, again]) = first_repeated(&inputs, |a, b| a.parameter == b.parameter) {
            let name = inputs[again].parameter.name;
            return Err(Error::unreadable(
                name,
                "it has two distributions; keep one",
            ));
        }
        let matrix = correlation_matrix(&inputs, correlations)?;
        let contradiction = |i: usize| {
            let name = inputs[i].parameter.name;
            let source = format!(
                "those of {name} contradict the others: no distribution has them all (the matrix is \
                 not positive semidefinite); make them smaller"
            );
            Error::unreadable("the correlations", source)
        };
        let factor = factored(&matrix).map_err(contradiction)?;
        Ok(Self::Distributed { inputs, factor })
    }

    /// Recorded swings.
    ///
    /// # Errors
    /// [`Error::Nothing`] without a swing or a parameter; [`Error::Unreadable`] for a row that does
    /// not have one value for each parameter, and for a value that is missing (NaN) or outside the
    /// allowed range.
    pub fn recorded(parameters: Vec<&'static Parameter>, rows: Vec<Vec<f64>>) -> Result<Self> {
        if parameters.is_empty() || rows.is_empty() {
            return Err(Error::Nothing {
                doing: "swing",
                what: "recorded swing",
            });
        }
        for (k, row) in rows.iter().enumerate() {
            let name = || format!("recorded swing {}", k + 1);
            if row.len() != parameters.len() {
                let source = format!(
                    "it has {} for {}; give one value for each parameter",
                    counted(row.len() as u64, "value"),
                    counted(parameters.len() as u64, "parameter")
                );
                return Err(Error::unreadable(name(), source));
            }
            for (parameter, value) in parameters.iter().zip(row) {
                if value.is_nan() {
                    let source = format!(
                        "{} is missing; fill its cell, or leave the row out",
                        parameter.name
                    );
                    return Err(Error::unreadable(name(), source));
                }
                parameter
                    .check(*value)
                    .map_err(|source| Error::unreadable(name(), source))?;
            }
        }
        Ok(Self::Recorded {
            parameters,
            rows,
            remarks: vec![],
        })
    }

    /// The parameters that vary.
    pub fn parameters(&self) -> Vec<&'static Parameter> {
        match self {
            Self::Distributed { inputs, .. } => {
                inputs.iter().map(|input| input.parameter).collect()
            }
            Self::Recorded { parameters, .. } => parameters.clone(),
        }
    }

    /// Mean of each parameter that varies.
    pub fn means(&self) -> Vec<f64> {
        match self {
            Self::Distributed { inputs, .. } => inputs
                .iter()
                .map(|input| input.distribution.mean())
                .collect(),
            Self::Recorded {
                parameters, rows, ..
            } => {
                let mean =
                    |i: usize| rows.iter().map(|row| row[i]).sum::<f64>() / rows.len() as f64;
                (0..parameters.len()).map(mean).collect()
            }
        }
    }
}

/// Cholesky factor of a positive semidefinite matrix A with unit diagonal: the lower triangular L
/// with A = L Lᵀ. If A is not positive semidefinite, the error is the index of the row at which the
/// factorization fails.
fn factored(a: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, usize> {
    /// A negative pivot above −`ROUNDING` counts as 0: rounding can make a pivot of a singular
    /// matrix negative.
    const ROUNDING: f64 = 1e-12;
    let n = a.len();
    let mut l = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let left = a[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            if i == j {
                if left < -ROUNDING {
                    return Err(i);
                }
                l[i][i] = left.max(0.0).sqrt();
            } else if l[j][j] > ROUNDING.sqrt() {
                l[i][j] = left / l[j][j];
            } else if left.abs() > ROUNDING.sqrt() {
                return Err(i);
            }
        }
    }
    Ok(l)
}

#[cfg(test)]
mod tests {
    use super::factored;

    #[test]
    fn exact_factor_of_correlations_and_none_if_indefinite() {
        let a = [
            vec![1.0, 0.5, 0.2],
            vec![0.5, 1.0, -0.3],
            vec![0.2, -0.3, 1.0],
        ];
        let l = factored(&a).unwrap();
        for i in 0..3 {
            for j in 0..3 {
                let product: f64 = (0..3).map(|k| l[i][k] * l[j][k]).sum();
                assert!((product - a[i][j]).abs() < 1e-15);
            }
        }
        // three variables cannot all have strong negative correlations with each other
        let opposite = [
            vec![1.0, -0.9, -0.9],
            vec![-0.9, 1.0, -0.9],
            vec![-0.9, -0.9, 1.0],
        ];
        assert_eq!(factored(&opposite), Err(2));
        // two fully correlated variables
        assert!(factored(&[vec![1.0, 1.0], vec![1.0, 1.0]]).is_ok());
    }
}
