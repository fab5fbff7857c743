use super::http::{HttpResponse, MOST_BYTES, Site, TOO_MANY, refusal};
use super::page::{PAGE, policy, refused};
use crate::command::interrupt;
use crate::command::listener::Listener;
use crate::command::output::note;
use crate::command::running::running;
use crate::{Error, Result};
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Ipv4Addr, Shutdown, SocketAddr, TcpStream};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Time for a request to arrive.
const REQUEST_TIME: Duration = Duration::from_secs(5);
/// Time for a client to read a response and close its connection.
const CLOSING_TIME: Duration = Duration::from_secs(1);

/// Serves the page until Ctrl-C. Prints the address of the page, which ends with `#` and `state`.
///
/// # Errors
/// If no port or no random number is available, or if the page in this program was not made by
/// web/build.
pub fn serve(state: &str) -> Result<()> {
    let wanted = SocketAddr::new(Ipv4Addr::LOCALHOST.into(), 0);
    let listener = Listener::bind(wanted)
        .map_err(|error| refused(&format!("no port of this machine is free: {error}")))?;
    let site = Site {
        port: listener.address.port(),
        path: random_path()?,
        page: PAGE,
        policy: policy(PAGE).ok_or_else(|| {
            refused(
                "the page that is compiled in is not that of web/build; run web/build, and build \
                 again",
            )
        })?,
    };
    let work = interrupt::enable("ending");
    let address = format!("http://{}{}#{state}\n", listener.address, site.path);
    running()
        .host
        .write(address.as_bytes())
        .map_err(Error::Output)?;
    note("open this address in a browser; Ctrl-C ends");
    let stop = &work.stop;
    listener.serve(stop, TOO_MANY, |stream| answer(stream, &site, stop));
    Ok(())
}

/// A path that other programs and pages cannot guess: 128 random bits.
fn random_path() -> Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes)
        .map_err(|error| refused(&format!("the system has no random numbers: {error}")))?;
    let digits = bytes.map(|byte| format!("{byte:02x}"));
    Ok(format!("/{}", digits.concat()))
}

/// Answers one request, and closes the connection.
fn answer(mut stream: TcpStream, site: &Site<'_>, stop: &AtomicBool) -> io::Result<()> {
    let mut bytes = vec![];
    let Some(response) = response(&mut stream, &mut bytes, site, stop)? else {
        return Ok(());
    };
    stream.write_all(response.head.as_bytes())?;
    stream.write_all(response.body)?;
    stream.shutdown(Shutdown::Write)?;
    discard_rest(&mut stream, stop);
    Ok(())
}

/// Reads a request, and returns the response to it; `None` for a connection without a request.
fn response<'a>(
    stream: &mut TcpStream,
    bytes: &mut Vec<u8>,
    site: &'a Site<'_>,
    stop: &AtomicBool,
) -> io::Result<Option<HttpResponse<'a>>> {
    let began = Instant::now();
    let mut piece = [0; 4096];
    while !stop.load(Ordering::Relaxed) && began.elapsed() < REQUEST_TIME {
        match stream.read(&mut piece) {
            Ok(0) => break,
            Ok(read) => {
                let room = MOST_BYTES - bytes.len();
                bytes.extend_from_slice(&piece[..read.min(room)]);
                if let Some(response) = site.response(bytes) {
                    return Ok(Some(response));
                }
            }
            Err(error) if is_timeout(&error) => {}
            Err(error) => return Err(error),
        }
    }
    let text = "The request does not end.\n";
    Ok((!bytes.is_empty()).then(|| refusal("408 Request Timeout", "", text)))
}

/// Reads and discards the rest of the client's data. Closing a connection with unread data would
/// reset it, and the client could not read the response.
fn discard_rest(stream: &mut TcpStream, stop: &AtomicBool) {
    let began = Instant::now();
    let mut piece = [0; 4096];
    while !stop.load(Ordering::Relaxed) && began.elapsed() < CLOSING_TIME {
        match stream.read(&mut piece) {
            Ok(0) => return,
            Ok(_) => {}
            Err(error) if is_timeout(&error) => {}
            Err(_) => return,
        }
    }
}

fn is_timeout(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted
    )
}
