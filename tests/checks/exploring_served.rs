//! The explorer, served by the program over HTTP.

#![cfg(unix)]

use crate::command_line::{interrupt, on_one_line};
use crate::program;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::process::{Child, Output, Stdio};
use std::time::Duration;

/// The page that is compiled in.
const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../web/dist/explorer.html");

/// The serving program, with its address.
struct Server {
    child: Child,
    port: u16,
    path: String,
    /// The fragment of the address, after `#`.
    state: String,
}

impl Server {
    fn new(args: &[&str]) -> Self {
        let mut child = program::command()
            .arg("explore")
            .args(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().unwrap())
            .read_line(&mut line)
            .unwrap();
        let (address, state) = line.trim_end().split_once('#').expect("an address");
        let (port, path) = address
            .strip_prefix("http://127.0.0.1:")
            .and_then(|rest| rest.split_once('/'))
            .expect("a port of this machine");
        Self {
            port: port.parse().unwrap(),
            path: format!("/{path}"),
            state: state.into(),
            child,
        }
    }

    fn stream(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        let patience = Some(Duration::from_secs(20));
        stream.set_read_timeout(patience).unwrap();
        stream
    }

    /// The response to a request of these bytes.
    fn answer(&self, request: &[u8]) -> Response {
        let mut stream = self.stream();
        stream.write_all(request).unwrap();
        Response::read(stream)
    }

    fn get(&self, path: &str, host: &str) -> Response {
        self.answer(format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n").as_bytes())
    }

    fn own_host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    /// Ends the program by Ctrl-C.
    fn ended(self) -> Output {
        interrupt(&self.child);
        self.child.wait_with_output().unwrap()
    }
}

struct Response {
    status: u16,
    head: String,
    body: Vec<u8>,
}

impl Response {
    fn read(mut stream: TcpStream) -> Self {
        let mut bytes = vec![];
        stream.read_to_end(&mut bytes).unwrap();
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n");
        let body = bytes.split_off(end.expect("a head") + 4);
        let head = String::from_utf8(bytes).unwrap();
        Self {
            status: head.split(' ').nth(1).unwrap().parse().unwrap(),
            head,
            body,
        }
    }

    fn header(&self, name: &str) -> Option<&str> {
        let mut lines = self.head.lines();
        lines.find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    }
}

#[test]
fn same_page_at_its_address_as_in_the_file() {
    let server = Server::new(&[]);
    let page = std::fs::read(PAGE).unwrap();
    for host in [server.own_host(), format!("localhost:{}", server.port)] {
        let got = server.get(&server.path, &host);
        assert_eq!(got.status, 200, "{}", got.head);
        assert!(
            got.body == page,
            "{} of {} bytes",
            got.body.len(),
            page.len()
        );
    }
    let head = format!(
        "HEAD {} HTTP/1.1\r\nHost: {}\r\n\r\n",
        server.path,
        server.own_host()
    );
    let got = server.answer(head.as_bytes());
    assert_eq!((got.status, got.body.len()), (200, 0));
    assert_eq!(got.header("Content-Length"), Some(&*page.len().to_string()));
    let output = server.ended();
    assert_eq!(output.status.code(), Some(0));
    let answered = String::from_utf8(output.stderr).unwrap();
    assert!(
        answered.contains("Ctrl-C ends") && answered.contains("ending; press Ctrl-C again"),
        "{answered}"
    );
}

#[test]
fn the_response_forbids_what_the_page_forbids_and_more() {
    let server = Server::new(&[]);
    let got = server.get(&server.path, &server.own_host());
    let page = String::from_utf8_lossy(&got.body).into_owned();
    let policy = got.header("Content-Security-Policy").unwrap();
    let stated = policy.strip_suffix("; frame-ancestors 'none'").unwrap();
    assert!(page.contains(&format!("content=\"{stated}\"")), "{policy}");
    assert!(stated.starts_with("default-src 'none'"), "{policy}");
    assert_eq!(got.header("X-Content-Type-Options"), Some("nosniff"));
    assert_eq!(got.header("Cache-Control"), Some("no-store"));
    assert_eq!(got.header("Referrer-Policy"), Some("no-referrer"));
    let charset = got
        .header("Content-Type")
        .unwrap()
        .split_once("charset=")
        .unwrap()
        .1;
    assert!(
        page.contains(&format!("<meta charset=\"{charset}\">")),
        "{charset}"
    );
    server.ended();
}

#[test]
fn other_paths_hosts_and_methods_get_no_page() {
    let server = Server::new(&[]);
    let (own, path) = (server.own_host(), server.path.clone());
    let port = server.port;
    assert!(path.len() > 32, "{path}");
    let host = |name: &str| format!("Host: {name}\r\n");
    let ours = host(&own);
    let get = |path: &str| format!("GET {path}");
    for (first, headers, status) in [
        (get(&path), format!("hOST: localhost:{port}\r\n"), 200),
        (get("/"), ours.clone(), 404),
        (get("/explorer.html"), ours.clone(), 404),
        (get(&path[..path.len() - 1]), ours.clone(), 404),
        (get(&path.to_uppercase()), ours.clone(), 404),
        (get(&format!("{path}/")), ours.clone(), 404),
        (get(&format!("{path}?a")), ours.clone(), 404),
        (get(&format!("/a/..{path}")), ours.clone(), 404),
        (get(&format!("http://{own}{path}")), ours.clone(), 404),
        (get(&path), host("evil.example"), 403),
        (get(&path), host(&format!("evil.example:{port}")), 403),
        (get(&path), host(&format!("{own}.evil.example")), 403),
        (get(&path), host(&format!("{own}0")), 403),
        (get(&path), host("127.0.0.1"), 403),
        (get(&path), format!("{ours}{}", host("evil.example")), 403),
        (get(&path), String::new(), 403),
        (format!("PUT {path}"), ours.clone(), 405),
        (format!("OPTIONS {path}"), host("evil.example"), 405),
    ] {
        let request = format!("{first} HTTP/1.1\r\n{headers}\r\n");
        let got = server.answer(request.as_bytes());
        assert_eq!(got.status, status, "{request}");
        assert!(status == 200 || got.body.len() < 200, "{request}");
    }
    let post = format!(
        "POST {path} HTTP/1.1\r\n{ours}Content-Length: 100000\r\n\r\n{}",
        "a".repeat(100_000)
    );
    let got = server.answer(post.as_bytes());
    assert_eq!((got.status, got.header("Allow")), (405, Some("GET, HEAD")));
    server.ended();
}

#[test]
fn same_page_for_a_request_in_pieces() {
    let server = Server::new(&[]);
    let request = format!(
        "GET {} HTTP/1.1\r\nHost: {}\r\n\r\n",
        server.path,
        server.own_host()
    );
    let mut stream = server.stream();
    stream.set_nodelay(true).unwrap();
    for piece in request.as_bytes().chunks(20) {
        stream.write_all(piece).unwrap();
        std::thread::sleep(Duration::from_millis(10));
    }
    let got = Response::read(stream);
    assert!(got.status == 200 && got.body == std::fs::read(PAGE).unwrap());
    server.ended();
}

#[test]
fn garbage_and_long_requests_are_refused_and_the_page_is_still_served() {
    let server = Server::new(&[]);
    let long = format!("GET /{} HTTP/1.1\r\n\r\n", "a".repeat(100_000));
    let many = format!("GET / HTTP/1.1\r\n{}\r\n", "a: b\r\n".repeat(500));
    let tls: Vec<u8> = (0..=255).rev().collect();
    for (request, status) in [
        (long.as_bytes(), 431),
        (many.as_bytes(), 431),
        (&tls, 400),
        (b"\r\n\r\n \r\n", 400),
    ] {
        assert_eq!(server.answer(request).status, status, "{:?}", &request[..4]);
    }
    let mut cut = server.stream();
    cut.write_all(b"GET / HT").unwrap();
    cut.shutdown(Shutdown::Write).unwrap();
    assert_eq!(Response::read(cut).status, 408);
    let unread = server.stream();
    drop(unread);
    assert_eq!(server.get(&server.path, &server.own_host()).status, 200);
    server.ended();
}

#[test]
fn two_at_once_are_served_while_a_third_is_silent() {
    let server = Server::new(&[]);
    let silent = server.stream();
    std::thread::scope(|scope| {
        let get = || server.get(&server.path, &server.own_host()).status;
        let both = [scope.spawn(get), scope.spawn(get)];
        assert_eq!(both.map(|one| one.join().unwrap()), [200, 200]);
    });
    // Ctrl-C ends the program although a connection is open on which the client sends nothing
    assert_eq!(server.ended().status.code(), Some(0));
    drop(silent);
}

#[test]
fn exact_address_of_a_preset_with_changes_and_units() {
    let server = Server::new(&["--speed", "100mph", "--set", "club.loft=10.5 deg"]);
    assert_eq!(
        server.state,
        "1&tour-average&swing.speed=100mph&club.loft=10.5deg"
    );
    let other = Server::new(&["mae494", "--units", "metric", "--quiet"]);
    assert_eq!(other.state, "1&mae494&units=metric");
    assert_ne!((server.port, &server.path), (other.port, &other.path));
    server.ended();
    other.ended();
}

#[test]
fn exact_address_of_a_setup_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    let text =
        "preset = 'modern-driver'\ngolfer = 'left'\n[wind]\nspeed = '10 mph'\nfrom = '90 deg'\n";
    std::fs::write(&file, text).unwrap();
    let server = Server::new(&[file.to_str().unwrap()]);
    assert_eq!(
        server.state,
        "1&modern-driver&golfer=left&wind.speed=10mph&wind.from=90deg"
    );
    server.ended();
}

#[test]
fn bad_input_is_refused_before_anything_is_served() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("mine.csv");
    let rows = "spin_ratio,cd,cl\n0,0.2,0\n0.1,0.22,0.12\n0.2,0.25,0.2\n0.3,0.28,0.25\n";
    std::fs::write(&table, rows).unwrap();
    let own_table = format!("aero.table={}", table.display());
    for (args, says) in [
        (vec!["tour"], "did you mean 'tour-average'?"),
        (vec!["--set", "club.loft=95deg"], "club.loft"),
        (vec!["--json"], "unexpected argument '--json'"),
        (
            vec!["--set", &own_table],
            "the explorer cannot have your own table",
        ),
    ] {
        let mut explore = program::command();
        let output = explore.arg("explore").args(&args).output().unwrap();
        let answered = on_one_line(&String::from_utf8(output.stderr).unwrap());
        assert_eq!(output.status.code(), Some(2), "{args:?}: {answered}");
        assert!(answered.contains(says), "{args:?}: {answered}");
        let printed = String::from_utf8(output.stdout).unwrap();
        assert!(!printed.contains("http:"), "{args:?}: {printed}");
    }
}
