//! The core of the explorer: longdrive for WebAssembly, behind seven functions.
//!
//! `README.md` has their requests and answers. A function reads a [`message`], calls the library,
//! and writes a message; nothing is kept between two calls.

pub mod aim;
pub mod ask;
pub mod drive;
#[cfg(target_family = "wasm")]
mod endpoints;
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
use serde::de::DeserializeOwned;

/// The functions that the core offers to the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Endpoint {
    /// A command of the program.
    Ask,
    /// A drive with derivatives and path.
    Drive,
    /// Outcomes over two parameters.
    Map,
    /// The values of two parameters with which the ball lands at a point.
    Aim,
    /// The while-loop of the MAE 494 report.
    Loop,
    /// The step of the integration.
    Step,
    /// The iterations of the search for the best drive.
    Iterations,
}

/// Answers a request. A request that cannot be answered has an answer with the reason.
pub fn answered(endpoint: Endpoint, request: &[u8], show: ShowProgress) -> Vec<u8> {
    let answer = Message::read(request).and_then(|request| match endpoint {
        Endpoint::Ask => ask::answer(&head(&request)?, request.block, show),
        Endpoint::Drive => drive::answer(&head(&request)?),
        Endpoint::Map => map::answer(&head(&request)?),
        Endpoint::Aim => aim::answer(&head(&request)?),
        Endpoint::Loop => while_loop::answer(&head(&request)?),
        Endpoint::Step => step::answer(&head(&request)?),
        Endpoint::Iterations => iterations::answer(&head(&request)?),
    });
    answer.unwrap_or_else(|refusal| message::with_numbers(&refusal, &refusal.values))
}

fn head<T: DeserializeOwned>(request: &Message<'_>) -> Result<T, Refusal> {
    serde_json::from_slice(request.head).map_err(|error| Refusal::of_request(&error.to_string()))
}
