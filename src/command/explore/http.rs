//! The part of HTTP/1.1 that a server of one page needs: requests and responses.

use httparse::{EMPTY_HEADER, Error, Header, Request, Status};

/// Maximum length of the head of a request, bytes.
pub const MOST_BYTES: usize = 16 << 10;
/// Maximum number of headers of a request.
const MOST_HEADERS: usize = 64;

/// The response if the maximum number of connections is already open.
pub const TOO_MANY: &[u8] =
    b"HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\nConnection: close\r\n\r\n";

/// A response: its head and its body.
pub struct HttpResponse<'a> {
    pub head: String,
    pub body: &'a [u8],
}

/// One page at one path of this machine.
pub struct Site<'a> {
    pub port: u16,
    /// The path of the page, a secret: only the printed address contains it.
    pub path: String,
    pub page: &'a [u8],
    /// The content security policy of the page.
    pub policy: &'a str,
}

/// A response without the page: a status and a text. `more` has additional headers.
pub fn refusal(status: &str, more: &str, text: &'static str) -> HttpResponse<'static> {
    HttpResponse {
        head: head(status, "text/plain; charset=utf-8", text.len(), more),
        body: text.as_bytes(),
    }
}

fn head(status: &str, kind: &str, length: usize, more: &str) -> String {
    format!(
        "HTTP/1.1 {status}\r\n\
         Content-Type: {kind}\r\n\
         Content-Length: {length}\r\n\
         Cache-Control: no-store\r\n\
         X-Content-Type-Options: nosniff\r\n\
         Referrer-Policy: no-referrer\r\n\
         Cross-Origin-Resource-Policy: same-origin\r\n\
         {more}\
         Connection: close\r\n\r\n"
    )
}

impl Site<'_> {
    /// The response to the bytes of a request so far; `None` while its head is incomplete.
    pub fn response(&self, bytes: &[u8]) -> Option<HttpResponse<'_>> {
        let mut headers = [EMPTY_HEADER; MOST_HEADERS];
        let mut request = Request::new(&mut headers);
        match request.parse(bytes) {
            Ok(Status::Complete(_)) => Some(self.answer(&request)),
            Ok(Status::Partial) if bytes.len() < MOST_BYTES => None,
            Ok(Status::Partial) | Err(Error::TooManyHeaders) => Some(refusal(
                "431 Request Header Fields Too Large",
                "",
                "The request is too long.\n",
            )),
            Err(_) => Some(refusal("400 Bad Request", "", "This is not HTTP.\n")),
        }
    }

    fn answer(&self, request: &Request<'_, '_>) -> HttpResponse<'_> {
        let is_head = request.method == Some("HEAD");
        let response = if !is_head && request.method != Some("GET") {
            let text = "Only GET and HEAD are answered here.\n";
            refusal("405 Method Not Allowed", "Allow: GET, HEAD\r\n", text)
        } else if !self.is_own_host(request.headers) {
            let text =
                "The request is for another host; open the address that longdrive printed.\n";
            refusal("403 Forbidden", "", text)
        } else if request.path != Some(&self.path) {
            let text = "There is nothing here; open the address that longdrive printed.\n";
            refusal("404 Not Found", "", text)
        } else {
            self.page()
        };
        if is_head {
            return HttpResponse {
                body: b"",
                ..response
            };
        }
        response
    }

    /// True for a request with exactly one `Host` header, which names this server. The check
    /// protects against DNS rebinding, in which the host name of another page resolves to this
    /// machine.
    fn is_own_host(&self, headers: &[Header<'_>]) -> bool {
        let own = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{}", self.port));
        let is_host = |header: &&Header<'_>| header.name.eq_ignore_ascii_case("host");
        let mut hosts = headers.iter().filter(is_host);
        let host = hosts.next().map(|header| header.value);
        hosts.next().is_none() && own.iter().any(|own| host == Some(own.as_bytes()))
    }

    fn page(&self) -> HttpResponse<'_> {
        // prevent clickjacking: another page could show this page in an invisible frame
        let more = format!(
            "Content-Security-Policy: {}; frame-ancestors 'none'\r\n",
            self.policy
        );
        HttpResponse {
            // The page contains the compiled core as text. In this encoding, each byte of the text
            // is one character.
            head: head(
                "200 OK",
                "text/html; charset=windows-1252",
                self.page.len(),
                &more,
            ),
            body: self.page,
        }
    }
}
