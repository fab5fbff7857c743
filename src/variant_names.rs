//! Enums whose variants have names in files, in JSON and on the command line.

/// Names the variants of an enum. The enum gets `ALL`, `NAMES`, `name()`, and a `Display` that writes the
/// name. With `as "Schema"` it also gets a JSON schema of this name, in which the names of the
/// variants are the allowed strings.
macro_rules! variant_names {
    ($(#[doc = $doc:literal])* $Enum:ident as $schema:literal { $($names:tt)* }) => {
        variant_names! { $(#[doc = $doc])* $Enum { $($names)* } }

        #[cfg(test)]
        impl schemars::JsonSchema for $Enum {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                $schema.into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!({ "type": "string", "enum": Self::NAMES })
            }
        }
    };

    ($(#[doc = $doc:literal])* $Enum:ident { $($Variant:ident = $name:literal,)+ }) => {
        impl $Enum {
            /// All variants, in their order.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$Variant),+];

            /// The names of all variants, in their order.
            pub const NAMES: [&'static str; Self::ALL.len()] = [$($name),+];

            $(#[doc = $doc])*
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$Variant => $name,)+
                }
            }
        }

        /// The name.
        impl std::fmt::Display for $Enum {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }
    };
}
