//! Connections over TCP, each served on a thread of its own until Ctrl-C.

use std::io::{self, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

/// Timeout of one read, and the interval between checks for Ctrl-C while a client is silent.
pub const PATIENCE: Duration = Duration::from_millis(200);
/// Timeout of one write.
const WRITE_PATIENCE: Duration = Duration::from_secs(2);
/// Interval between checks for a new connection.
const PAUSE: Duration = Duration::from_millis(20);
/// Maximum number of simultaneous connections.
const MOST: u64 = 64;

/// A listener with its address.
pub struct Listener {
    listener: TcpListener,
    pub address: SocketAddr,
}

impl Listener {
    /// Listens on an address; port 0 selects a free port.
    ///
    /// # Errors
    /// If the address cannot be used.
    pub fn bind(wanted: SocketAddr) -> io::Result<Self> {
        let listener = TcpListener::bind(wanted)?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok(Self { listener, address })
    }

    /// Serves connections until `stop` is true. While the maximum number of connections is open, a
    /// new connection receives `too_many`. Returns the number of connections that were served.
    pub fn serve(
        &self,
        stop: &AtomicBool,
        too_many: &[u8],
        serve: impl Fn(TcpStream) -> io::Result<()> + Sync,
    ) -> u64 {
        let mut connections = 0;
        let open = AtomicU64::new(0);
        std::thread::scope(|scope| {
            while !stop.load(Ordering::Relaxed) {
                match self.listener.accept() {
                    Ok((stream, _)) if open.load(Ordering::Relaxed) < MOST => {
                        connections += 1;
                        open.fetch_add(1, Ordering::Relaxed);
                        let (open, serve) = (&open, &serve);
                        scope.spawn(move || {
                            // ignore errors: a client may close its connection
                            let _ = prepared(stream).and_then(serve);
                            open.fetch_sub(1, Ordering::Relaxed);
                        });
                    }
                    Ok((mut stream, _)) => {
                        let _ = stream.write_all(too_many);
                    }
                    Err(_) => std::thread::sleep(PAUSE),
                }
            }
        });
        connections
    }
}

/// The stream of a connection, with its timeouts.
fn prepared(stream: TcpStream) -> io::Result<TcpStream> {
    stream.set_nonblocking(false)?;
    stream.set_nodelay(true)?;
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(WRITE_PATIENCE))?;
    Ok(stream)
}
