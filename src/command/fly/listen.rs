//! Flies shots that arrive over the network.

use super::args::Args;
use super::request::{flying_within_tolerance, requested_outcomes, setup};
use crate::batch::Status;
use crate::command::interrupt;
use crate::command::listener::Listener;
use crate::command::output::{Answer, is_json, note, warnings};
use crate::command::request::Request;
use crate::parameters::{DEFAULT_PRESET, Golfer};
use crate::report::{Reply, open_connect_answer};
use crate::shots::{Flying, Objects};
use crate::units::counted;
use crate::{Error, Result};
use serde::Serialize;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// The answer if the maximum number of connections is already open.
const TOO_MANY: &[u8] =
    b"{\"Code\":503,\"Message\":\"there are too many connections; close one\"}\n";

/// Numbers of messages that a listener received, by kind of answer.
#[derive(Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct MessageCounts {
    /// Address and port of the listener.
    address: String,
    /// Number of connections.
    connections: u64,
    /// Number of shots that were answered with a flight (code 200).
    flown: AtomicU64,
    /// Number of shots whose ball does not land (code 200).
    not_landed: AtomicU64,
    /// Number of messages without a shot (code 201).
    others: AtomicU64,
    /// Number of messages that cannot be read (code 501).
    refused: AtomicU64,
}

/// The error if a file of shots is given with `--listen`. The file would be the setup; `why` is the
/// reason why it is no setup.
fn both_given(file: &Path, why: &str) -> Error {
    let file = file.display();
    let source = format!(
        "with `listen` the file is the setup of all messages, and {file} is not a setup ({why}); \
         to fly the shots of {file} leave `listen` out"
    );
    Error::unreadable(
        format!("`listen` and the shots {file} are both given"),
        source,
    )
}

pub fn run(args: &Args, port: u16) -> Result<Answer> {
    let request = request(args)?;
    let setup = setup(&request, "the messages")?;
    request.refuse_replaced(&setup, &[])?;
    let of = requested_outcomes(args)?;
    let flying = flying_within_tolerance(&request, &setup, &[], &of)?;
    let wanted = SocketAddr::new(args.address, port);
    let listener = Listener::bind(wanted).map_err(|error| refused(wanted, &error))?;
    let work = interrupt::enable("ending after the messages under way");
    note(&format!(
        "listening on {} for messages of GSPro Open Connect; Ctrl-C ends",
        listener.address
    ));
    let mut counts = MessageCounts {
        address: listener.address.to_string(),
        ..MessageCounts::default()
    };
    let stop = &work.stop;
    counts.connections = listener.serve(stop, TOO_MANY, |stream| {
        serve(stream, &flying, setup.golfer, stop, &counts)
    });
    Ok(if is_json() {
        Answer::json(&Reply::done("fly", warnings(), &counts))
    } else {
        Answer::text(format!(
            "{} flown, {} without a landing, {} without a shot, {} refused, over {}\n",
            counted(counts.flown.into_inner(), "shot"),
            counted(counts.not_landed.into_inner(), "shot"),
            counted(counts.others.into_inner(), "message"),
            counted(counts.refused.into_inner(), "message"),
            counted(counts.connections, "connection")
        ))
    })
}

/// The request of `--listen`. The first argument is the setup, because no file of shots is read.
fn request(args: &Args) -> Result<Request> {
    let shots = args.shots.as_ref();
    if let Some(shots) = shots.filter(|_| args.setup_args.drive.setup != DEFAULT_PRESET) {
        return Err(both_given(shots, "a setup is given after it"));
    }
    let mut setup_args = args.setup_args.clone();
    if let Some(setup) = shots {
        setup_args.drive.setup = setup.display().to_string();
    }
    setup_args.request().map_err(|error| match (shots, error) {
        (Some(shots), Error::Toml { message, .. }) => both_given(shots, &message),
        (_, error) => error,
    })
}

/// Answers the messages of a connection until the client closes it.
fn serve(
    mut stream: TcpStream,
    flying: &Flying,
    golfer: Golfer,
    stop: &AtomicBool,
    counts: &MessageCounts,
) -> io::Result<()> {
    let mut objects = Objects::default();
    let mut bytes = vec![0; 1 << 14];
    while !stop.load(Ordering::Relaxed) {
        let is_open = match stream.read(&mut bytes) {
            Ok(0) => {
                objects.finish();
                false
            }
            Ok(read) => {
                objects.push(&bytes[..read]);
                true
            }
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {
                // the client is silent: an incomplete message counts as finished
                objects.finish();
                true
            }
            Err(error) if error.kind() == ErrorKind::Interrupted => true,
            Err(error) => return Err(error),
        };
        while let Some(message) = objects.next_record() {
            let flown = flying.message(message);
            let of = match flown.status(0) {
                Some(Status::Landed) => &counts.flown,
                Some(_) => &counts.not_landed,
                None if flown.shots[0]
                    .refusal()
                    .is_some_and(|refusal| refusal.is_no_shot()) =>
                {
                    &counts.others
                }
                None => &counts.refused,
            };
            of.fetch_add(1, Ordering::Relaxed);
            stream.write_all(&open_connect_answer(&flown, golfer))?;
        }
        if !is_open {
            break;
        }
    }
    Ok(())
}

/// The reason why the address cannot be used, with advice.
fn refused(address: SocketAddr, error: &io::Error) -> Error {
    let why = match error.kind() {
        ErrorKind::AddrInUse => {
            "another program listens there; end it, or take another port".to_owned()
        }
        ErrorKind::PermissionDenied => {
            "ports below 1024 need the rights of an administrator; take another port, as in \
             `listen 9210`"
                .into()
        }
        ErrorKind::AddrNotAvailable => {
            "it is not an address of this machine; leave `address` out, or name another".into()
        }
        ErrorKind::Unsupported => "there is no network here; give a file of shots instead".into(),
        _ => format!("the system says: {error}"),
    };
    Error::unreadable(format!("`listen {address}`"), why)
}
