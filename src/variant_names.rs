//! Enums whose variants have names in files, in JSON and on the command line.

/// Names the variants of an enum. The enum gets `ALL`, `NAMES`, `name()`, `from_name()`, and a
/// `Display` that writes the name. With `as "Schema"`, serde writes and reads a variant as its
/// name, and the enum has the JSON schema `Schema`, which allows the names of the variants.
macro_rules! variant_names {
    ($(#[doc = $doc:literal])* $Enum:ident as $schema:literal { $($names:tt)* }) => {
        variant_names! { $(#[doc = $doc])* $Enum { $($names)* } }

        /// Writes the name.
        impl serde::Serialize for $Enum {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }

        /// Reads the name.
        impl<'de> serde::Deserialize<'de> for $Enum {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let name = String::deserialize(deserializer)?;
                Self::from_name(&name)
                    .ok_or_else(|| serde::de::Error::unknown_variant(&name, &Self::NAMES))
            }
        }

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
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Variant => $name,)+
                }
            }

            /// The variant of this name.
            pub fn from_name(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|variant| variant.name() == name)
            }
        }

        /// Writes the name.
        impl std::fmt::Display for $Enum {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }
    };
}
