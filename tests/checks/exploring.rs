//! The command `explore` where it serves nothing.

use longdrive::command::{Host, Kind, run};
use std::io;
use std::sync::{Arc, Mutex};

/// A host without a terminal.
#[derive(Default)]
struct NoTerminal {
    said: Mutex<String>,
}

impl Host for NoTerminal {
    fn print(&self, _: &str) -> io::Result<()> {
        Ok(())
    }

    fn say(&self, _: Kind, text: &str) {
        self.said.lock().unwrap().push_str(text);
    }
}

#[test]
fn a_host_without_a_terminal_serves_nothing() {
    let host = Arc::new(NoTerminal::default());
    let words = ["longdrive", "explore", "mae494"];
    assert_eq!(run(words.map(Into::into).to_vec(), host.clone()), 2);
    let said = host.said.lock().unwrap();
    let expected = "explore: it serves a page until Ctrl-C, for which there is no terminal here; \
                    type it in a terminal: longdrive explore";
    assert_eq!(*said, expected);
}

#[cfg(not(feature = "explore"))]
#[test]
fn without_its_feature_the_command_names_what_to_type() {
    let said = crate::command_line::longdrive(&["explore"]);
    let err = said.err.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(said.status, 2, "{err}");
    let advice = "web/build, then cargo run --release --features explore -- explore";
    assert!(err.ends_with(advice), "{err}");
    // what is wrong with the setup is said first
    let wrong = crate::command_line::longdrive(&["explore", "tour"]);
    assert!(
        wrong.err.contains("did you mean 'tour-average'?"),
        "{}",
        wrong.err
    );
}
