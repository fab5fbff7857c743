//! The core of the explorer: longdrive for WebAssembly, with seven functions.
//!
//! `README.md` has their requests and answers. A function reads a [`Request`], calls the library,
//! and writes a [`message`]; nothing is kept between two calls.

pub mod aim;
pub mod ask;
pub mod drive;
#[cfg(target_family = "wasm")]
mod exports;
pub mod iterations;
pub mod map;
pub mod message;
pub mod refusal;
pub mod request;
pub mod step;
pub mod while_loop;
pub mod words;

use ask::ShowProgress;
use message::Message;
use refusal::Refusal;
use serde::Deserialize;

/// The head of a request: the function of the core that answers it, and its parts.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Request {
    /// A command of the program.
    Ask(ask::Request),
    /// A drive with derivatives and path.
    Drive(drive::Request),
    /// Outcomes over two parameters.
    Map(map::Request),
    /// The values of two parameters with which the ball lands at a point.
    Aim(aim::Request),
    /// The while-loop of the MAE 494 report.
    Loop(while_loop::Request),
    /// The step of the integration.
    Step(step::Request),
    /// The iterations of the search for the best drive.
    Iterations(iterations::Request),
}

/// Answers a message. A request that cannot be answered has an answer with the reason.
pub fn answered(message: &[u8], show: ShowProgress) -> Vec<u8> {
    let answer = Message::read(message).and_then(|message| answer(&message, show));
    answer.unwrap_or_else(|refusal| message::with_numbers(&refusal, &refusal.values))
}

fn answer(message: &Message<'_>, show: ShowProgress) -> Result<Vec<u8>, Refusal> {
    let request = serde_json::from_slice(message.head)
        .map_err(|error| Refusal::of_request(&error.to_string()))?;
    match request {
        Request::Ask(request) => ask::answer(&request, message.block, show),
        Request::Drive(request) => drive::answer(&request),
        Request::Map(request) => map::answer(&request),
        Request::Aim(request) => aim::answer(&request),
        Request::Loop(request) => while_loop::answer(&request),
        Request::Step(request) => step::answer(&request),
        Request::Iterations(request) => iterations::answer(&request),
    }
}
