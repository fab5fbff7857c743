//! Shots over TCP, as messages of GSPro Open Connect.

#![cfg(unix)]

use crate::command_line::interrupt;
use crate::program;
use crate::schema::faults;
use serde_json::Value;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::Duration;

const SHOT: &str = r#"{"DeviceID":"A","Units":"Yards","ShotNumber":1,"APIversion":"1","BallData":{"Speed":160.0,"SpinAxis":3.0,"TotalSpin":2500.0,"HLA":-1.5,"VLA":12.0},"ShotDataOptions":{"ContainsBallData":true}}"#;
const HEARTBEAT: &str =
    r#"{"DeviceID":"A","ShotDataOptions":{"ContainsBallData":false,"IsHeartBeat":true}}"#;

/// The listening program, with its port.
fn listening(more: &[&str]) -> (Child, u16) {
    let mut child = program::command()
        .args(["fly", "--listen", "0"])
        .args(more)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stderr.as_mut().unwrap())
        .lines()
        .map(Result::unwrap);
    let address = |line: String| {
        line.split_whitespace()
            .find_map(|word| word.strip_prefix("127.0.0.1:")?.parse().ok())
    };
    let port = lines.find_map(address).expect("it says where it listens");
    drop(lines);
    (child, port)
}

/// Ends the program by Ctrl-C: exit status and output.
fn ended(child: Child) -> (Option<i32>, String) {
    interrupt(&child);
    let output = child.wait_with_output().unwrap();
    (
        output.status.code(),
        String::from_utf8(output.stdout).unwrap(),
    )
}

struct Client(BufReader<TcpStream>);

impl Client {
    fn new(port: u16) -> Self {
        let stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
        stream.set_nodelay(true).unwrap();
        stream
            .set_read_timeout(Some(Duration::from_secs(20)))
            .unwrap();
        Self(BufReader::new(stream))
    }

    fn send(&mut self, text: &str) {
        self.0.get_mut().write_all(text.as_bytes()).unwrap();
    }

    fn answer(&mut self) -> Value {
        let mut line = String::new();
        self.0.read_line(&mut line).unwrap();
        serde_json::from_str(&line).unwrap_or_else(|error| panic!("{error}: {line}"))
    }
}

#[test]
fn the_player_has_the_hand_of_the_setup() {
    let folder = tempfile::tempdir().unwrap();
    let setup = folder.path().join("left.toml");
    std::fs::write(&setup, "golfer = \"left\"\n").unwrap();
    let hand = |more: &[&str]| {
        let (child, port) = listening(more);
        let mut client = Client::new(port);
        client.send(HEARTBEAT);
        let answer = client.answer();
        drop(client);
        ended(child);
        answer["Player"]["Handed"].clone()
    };
    assert_eq!([hand(&[]), hand(&[setup.to_str().unwrap()])], ["RH", "LH"]);
}

#[test]
fn every_message_is_answered_and_the_connection_stays() {
    let (child, port) = listening(&["--of", "carry_distance", "--json"]);
    let mut client = Client::new(port);
    client.send(SHOT);
    let answer = client.answer();
    assert_eq!(answer["Code"], 200);
    let carry = answer["Flight"]["carry_distance"].as_f64().unwrap();
    assert!((200.0..280.0).contains(&carry), "{answer}");
    for (sent, code, says) in [
        (HEARTBEAT.to_owned(), 201, "GSPro Player Information"),
        ("hello\n".into(), 501, "a message begins with {"),
        (
            "{\"BallData\": {\n".into(),
            501,
            "the JSON object does not end",
        ),
        ("{\"BallData\": }".into(), 501, "it is not valid JSON"),
        ("{}".into(), 501, "it has no BallData"),
        (
            SHOT.replace("160.0", "\"fast\""),
            501,
            "BallData.Speed: \"fast\" is not a number",
        ),
        (SHOT.replace("160.0", "900"), 501, "above 0 to 270 mph"),
        (
            SHOT.replace("\"VLA\":12.0", "\"VLA\":-30"),
            200,
            "the ball does not land",
        ),
    ] {
        client.send(&sent);
        let answer = client.answer();
        assert_eq!(answer["Code"], code, "{sent}: {answer}");
        assert!(
            answer["Message"].as_str().unwrap().contains(says),
            "{sent}: {answer}"
        );
    }
    // two messages in one piece, and one message in two pieces
    client.send(&format!("{SHOT}{SHOT}"));
    let (head, tail) = SHOT.split_at(70);
    assert_eq!(
        [client.answer(), client.answer()]
            .map(|answer| answer["Flight"]["carry_distance"].as_f64()),
        [Some(carry); 2]
    );
    client.send(head);
    std::thread::sleep(Duration::from_millis(20));
    client.send(tail);
    assert_eq!(
        client.answer()["Flight"]["carry_distance"].as_f64(),
        Some(carry)
    );
    // a second client connects while the first is still connected
    let mut other = Client::new(port);
    other.send(SHOT);
    assert_eq!(other.answer()["Code"], 200);
    let (status, out) = ended(child);
    let answer: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(faults("fly", &answer), [""; 0], "{answer:#}");
    assert_eq!((status, answer["status"].as_str()), (Some(0), Some("done")));
    assert_eq!(
        (
            &answer["flown"],
            &answer["not_landed"],
            &answer["others"],
            &answer["refused"],
            &answer["connections"]
        ),
        (&5.into(), &1.into(), &1.into(), &6.into(), &2.into())
    );
    let mut rest = String::new();
    assert_eq!(
        client.0.read_to_string(&mut rest).unwrap(),
        0,
        "the connection is closed"
    );
}

#[test]
fn three_hundred_shots_of_one_connection_are_each_answered() {
    let (child, port) = listening(&["mae494"]);
    let mut client = Client::new(port);
    for _ in 0..300 {
        client.send(SHOT);
        assert_eq!(client.answer()["Code"], 200);
    }
    let (status, out) = ended(child);
    assert!(
        status == Some(0) && out.starts_with("300 shots flown"),
        "{status:?} {out}"
    );
}

#[test]
fn a_used_port_is_reported_with_advice() {
    let (child, port) = listening(&[]);
    let printed = crate::command_line::longdrive(&["fly", "--listen", &port.to_string()]);
    assert!(
        printed.status == 2 && printed.err.contains("another program listens there"),
        "{}",
        printed.err
    );
    let printed =
        crate::command_line::longdrive(&["fly", "--listen", "0", "--address", "203.0.113.1"]);
    assert!(
        printed.status == 2 && printed.err.contains("is not an address of this machine"),
        "{}",
        printed.err
    );
    assert_eq!(ended(child).0, Some(0));
}
