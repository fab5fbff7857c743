//! The program: its commands are those of [`longdrive::command`].

fn main() -> std::process::ExitCode {
    longdrive::command::main()
}
