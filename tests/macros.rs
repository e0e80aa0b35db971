//! The macros as their users meet them: a crate that knows this one by another name is rebuilt when
//! its model changes, and told where the model is wrong.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A crate of its own in a temporary folder, which depends on this one under another name.
struct Foreign {
    folder: PathBuf,
}

impl Foreign {
    fn new() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("foreign crate");
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(folder.join("src")).expect("a folder");
        std::fs::create_dir_all(folder.join("models")).expect("a folder");
        let foreign = Self { folder };
        foreign.write(
            "Cargo.toml",
            &format!(
                "[package]\nname = \"foreign\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\
                 [dependencies.mechanisms]\npackage = \"flexure\"\npath = {:?}\n\
                 default-features = false\n[workspace]\n",
                root.display().to_string()
            ),
        );
        std::fs::copy(root.join("Cargo.lock"), foreign.folder.join("Cargo.lock"))
            .expect("the lock file");
        foreign
    }

    fn write(&self, path: &str, text: &str) {
        std::fs::write(self.folder.join(path), text).expect("a file");
    }

    fn run(&self) -> Output {
        let target = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .parent()
            .expect("a folder");
        Command::new(env!("CARGO"))
            .args(["run", "--quiet", "--offline"])
            .current_dir(&self.folder)
            // What this crate depends on is built there already.
            .env("CARGO_TARGET_DIR", target)
            .env_remove("RUSTFLAGS")
            .output()
            .expect("cargo runs")
    }
}

#[test]
fn a_renamed_crate_is_rebuilt_with_its_model() {
    let foreign = Foreign::new();
    let model = |value: &str| {
        format!(
            "model swing\n\nparam k = {value}\nslide mass along (1, 0) {{ mass = 1 kg }}\n\
             spring wall between ground and mass {{ stiffness = k }}\n"
        )
    };
    foreign.write(
        "src/main.rs",
        "#![deny(warnings, missing_docs)]\n#![forbid(unsafe_code)]\n//! A crate.\n\
         mechanisms::include_model!(\"models/swing.flex\");\n\
         fn main() {\n    swing::Params::default().prepare().expect(\"a model\");\n    \
         println!(\"{}\", swing::Params::default().k);\n}\n",
    );
    let told = |output: &Output| {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (text(&output.stdout), text(&output.stderr))
    };

    foreign.write("models/swing.flex", &model("1 kN/m"));
    // A warning in the expansion would be an error.
    let (out, err) = told(&foreign.run());
    assert_eq!(out, "1000\n", "{err}");

    foreign.write("models/swing.flex", &model("2 kN/m"));
    let (out, err) = told(&foreign.run());
    assert_eq!(out, "2000\n", "{err}");

    foreign.write("models/sizes.flex", "const scale = 3\n");
    let with_file = model("scale * 1 kN/m\nuse \"sizes.flex\"");
    foreign.write("models/swing.flex", &with_file);
    let (out, err) = told(&foreign.run());
    assert_eq!(out, "3000\n", "{err}");

    foreign.write("models/sizes.flex", "const scale = 4\n");
    let (out, err) = told(&foreign.run());
    assert_eq!(out, "4000\n", "{err}");

    foreign.write("models/swing.flex", &model("2 kN/m * q"));
    let (_, err) = told(&foreign.run());
    let errors = err.lines().filter(|line| line.starts_with("error")).count();
    // The mistake, and cargo's own line that the crate could not be compiled.
    assert_eq!(errors, 2, "{err}");
    assert!(err.contains("models/swing.flex:3:"), "{err}");
    assert!(err.contains("3 | param k = 2 kN/m * q"), "{err}");
}
