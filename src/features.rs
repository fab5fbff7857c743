//! What can be left out when longdrive is built.

/// What to do where a file's format needs a feature that this longdrive is built without.
///
/// ```
/// let words = longdrive::features::how_to_get("parquet");
/// assert!(words.ends_with("cargo install --path . --features parquet"));
/// ```
pub fn how_to_get(feature: &str) -> String {
    format!(
        "this longdrive is built without the feature {feature}; build one with it: cargo install \
         --path . --features {feature}"
    )
}
