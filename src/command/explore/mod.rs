//! Serves the explorer, a page with sliders, on this machine.

#[cfg(feature = "explore")]
mod http;
pub mod page;
#[cfg(feature = "explore")]
mod server;

pub use super::args::DriveArgs as Args;

#[cfg(feature = "explore")]
use server::serve;

use super::output::{Answer, system, warn};
use super::running::running;
use crate::Result;
use crate::report::explorer_state;
use page::refused;

pub fn run(args: &Args) -> Result<Answer> {
    if !running().host.is_terminal() {
        let why = "it serves a page until Ctrl-C, so it needs a terminal; type there: longdrive \
                   explore";
        return Err(refused(why));
    }
    let request = args.request()?;
    let setup = request.setup()?;
    let state = explorer_state(&setup, request.source.content.preset, system())?;
    warn(setup.warnings());
    serve(&state)?;
    Ok(Answer::text(String::new()))
}

#[cfg(not(feature = "explore"))]
fn serve(_: &str) -> Result<()> {
    Err(refused(crate::features::HOW_TO_EXPLORE))
}
