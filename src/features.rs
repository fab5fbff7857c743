//! Optional features of the build.

/// Message for a file format that needs a feature which is not compiled in.
///
/// ```
/// let words = longdrive::features::how_to_get("parquet");
/// assert!(words.ends_with("cargo install --path . --features parquet"));
/// ```
pub fn how_to_get(feature: &str) -> String {
    format!(
        "this longdrive is built without the feature {feature}; take .svg for a picture or .csv for \
         a table, or build longdrive with the feature: cargo install --path . --features {feature}"
    )
}

/// Message for the command `explore` without its feature.
pub const HOW_TO_EXPLORE: &str = "this longdrive is built without the feature explore; build the page, then the program with \
     it: web/build, then cargo run --release --features explore -- explore";
