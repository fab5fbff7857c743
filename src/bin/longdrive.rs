//! The program: runs the commands of [`longdrive::command`].

fn main() -> std::process::ExitCode {
    longdrive::command::main()
}
