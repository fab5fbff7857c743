//! JSON schemas of enums that are written as their names.

/// Implements `JsonSchema` for an enum with `ALL` and `name()`: the names are the allowed strings.
macro_rules! schema_of_names {
    ($Enum:ident, $name:literal) => {
        #[cfg(test)]
        impl schemars::JsonSchema for $Enum {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                $name.into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let names: Vec<_> = Self::ALL.iter().map(|of| of.name()).collect();
                schemars::json_schema!({ "type": "string", "enum": names })
            }
        }
    };
}
