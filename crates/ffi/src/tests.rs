//! Functions of the FMI called as an importer does: no allocation, faults, states.

use crate::fmi2::{self, Callbacks};
use crate::fmi3;
use crate::instance::{Instance, Log, Phase, Status};
use crate::location::MODEL;
use allocation_counter::measure;
use arcless_device::model::{Model, Part};
use arcless_device::pantograph::PantographModel;
use arcless_device::{Stepper, file};
use std::cell::RefCell;
use std::ffi::{CString, c_void};
use std::path::{Path, PathBuf};
use std::ptr::{null, null_mut};

/// A mass on a spring and a damper, at rest under 50 N, as bytes.
fn mass_on_spring() -> Vec<u8> {
    use arcless_core::pantograph::model::Pantograph;
    use arcless_core::pantograph::strip::Strip;
    let pantograph = Pantograph {
        mass: vec![10.0],
        damping: vec![80.0],
        stiffness: vec![100.0],
        strips: vec![Strip::plain(vec![1.0])],
        preload: vec![1.0],
        lift: vec![0.0],
        start_force: 50.0,
        excitation: Default::default(),
        stops: Vec::new(),
        piecewise_forces: Vec::new(),
        actuator: None,
        is_external: false,
    };
    let start = arcless_core::session::alone::AloneStart {
        displacements: vec![0.0],
        preload: 50.0,
        datum: 5.0,
        forces: vec![50.0],
        laterals: vec![0.0],
    };
    let model = PantographModel {
        name: "P1".into(),
        pantograph,
        scheme: arcless_core::scheme::Scheme::newmark(0.25, 0.5),
        step_length: 1e-3,
        start,
        speed: 50.0,
        heights: vec![(0, "mass_1".into())],
    };
    let part = Part::Pantograph(Box::new(model));
    file::pack(&Model::new(part)).expect("bytes")
}

/// Folder with the resources of an FMU, removed at the end.
struct Resources(PathBuf);

impl Resources {
    fn new(name: &str) -> Self {
        let folder =
            std::env::temp_dir().join(format!("arcless-ffi-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        std::fs::write(folder.join(MODEL), mass_on_spring()).expect("a file");
        Self(folder)
    }

    fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Resources {
    fn drop(&mut self) {
        // A folder left behind among temporary files harms nobody.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn token() -> CString {
    let stepper = Stepper::open(&mass_on_spring()).expect("a model");
    CString::new(file::token(stepper.digest())).expect("a string")
}

fn number(name: &str) -> u32 {
    let stepper = Stepper::open(&mass_on_spring()).expect("a model");
    stepper.find(name).expect("a variable") as u32
}

fn instance2(resources: &Resources) -> *mut c_void {
    let place = CString::new(format!("file://{}", resources.path().display())).expect("a string");
    // SAFETY: strings that end with a zero, and no functions of an importer.
    unsafe {
        let made = fmi2::fmi2Instantiate(
            c"one".as_ptr(),
            1,
            token().as_ptr(),
            place.as_ptr(),
            null::<Callbacks>(),
            0,
            0,
        );
        assert!(!made.is_null());
        assert_eq!(fmi2::fmi2SetupExperiment(made, 0, 0.0, 0.0, 0, 0.0), 0);
        assert_eq!(fmi2::fmi2EnterInitializationMode(made), 0);
        assert_eq!(fmi2::fmi2ExitInitializationMode(made), 0);
        made
    }
}

#[test]
fn steps_allocate_nothing() {
    let resources = Resources::new("steps");
    let made = instance2(&resources);
    let (force, all) = (
        number("contact_force"),
        [number("strip_height"), number("free_height")],
    );
    let mut out = [0.0; 2];
    let counted = measure(|| {
        for step in 0..200 {
            let given = 50.0 + (f64::from(step) * 0.1).sin();
            // SAFETY: an instance, and arrays of as many elements as is said.
            let done = unsafe {
                fmi2::fmi2SetReal(made, &force, 1, &given)
                    + fmi2::fmi2DoStep(made, f64::from(step) * 1e-3, 1e-3, 1)
                    + fmi2::fmi2GetReal(made, all.as_ptr(), 2, out.as_mut_ptr())
            };
            assert_eq!(done, 0);
        }
    });
    assert_eq!(counted.count_total, 0);
    assert!((out[0] - 5.0).abs() < 0.1 && out[0] != 5.0);
    // SAFETY: the instance is not used again.
    unsafe { fmi2::fmi2FreeInstance(made) };
}

/// The mass on its spring: m ü + c u̇ + k u = −ΔF. After a long time u = −ΔF/k.
#[test]
fn a_force_lowers_the_strip_as_its_spring_says() {
    let resources = Resources::new("spring");
    let place = CString::new(resources.path().display().to_string()).expect("a string");
    let (force, height) = (number("contact_force"), number("strip_height"));
    let (mut out, mut reached) = (0.0, 0.0);
    // SAFETY: strings that end with a zero, an instance, and places for numbers.
    unsafe {
        let made = fmi3::fmi3InstantiateCoSimulation(
            c"one".as_ptr(),
            token().as_ptr(),
            place.as_ptr(),
            0,
            0,
            0,
            0,
            null(),
            0,
            null_mut(),
            None,
            null_mut(),
        );
        assert!(!made.is_null());
        assert_eq!(
            fmi3::fmi3EnterInitializationMode(made, 0, 0.0, 2.0, 0, 0.0),
            0
        );
        assert_eq!(fmi3::fmi3ExitInitializationMode(made), 0);
        assert_eq!(fmi3::fmi3SetFloat64(made, &force, 1, &60.0, 1), 0);
        let flags = [null_mut(); 3];
        for step in 0..100 {
            let from = 2.0 + f64::from(step) * 0.1;
            let [event, end, early] = flags;
            let done = fmi3::fmi3DoStep(made, from, 0.1, 1, event, end, early, &mut reached);
            assert_eq!(done, 0);
        }
        assert_eq!(fmi3::fmi3GetFloat64(made, &height, 1, &mut out, 1), 0);
        fmi3::fmi3FreeInstance(made);
    }
    assert!((reached - 12.0).abs() < 1e-9);
    // 10 N on 100 N/m; what is left of the motion after 10 s is e^(−4·10).
    assert!((out - 4.9).abs() < 1e-12, "{out}");
}

#[derive(Default)]
struct Kept(RefCell<Vec<(Status, String)>>);

impl Log for &Kept {
    fn message(&self, status: Status, message: &str) {
        self.0.borrow_mut().push((status, message.into()));
    }
}

#[test]
fn a_panic_is_a_status_with_its_message() {
    let resources = Resources::new("panic");
    let kept = Kept::default();
    let location = resources.path().display().to_string();
    let guid = token().into_string().expect("text");
    let mut made = Instance::open(&location, &guid, &kept).expect("an instance");
    let status = made.attempt(|_| panic!("a hole in {}", "it"));
    assert_eq!((status, made.phase), (Status::Fatal, Phase::Broken));
    let said = kept.0.borrow()[0].clone();
    assert_eq!(said.0, Status::Fatal);
    assert!(
        said.1.ends_with("please report it: a hole in it"),
        "{}",
        said.1
    );
    assert_eq!(
        made.attempt(|_| Ok(())),
        Status::Fatal,
        "nothing is done any more"
    );
}

#[test]
fn null_pointers_are_refused() {
    let resources = Resources::new("null");
    let made = instance2(&resources);
    // SAFETY: null where a function has to look, else an instance.
    unsafe {
        assert_eq!(fmi2::fmi2DoStep(null_mut(), 0.0, 1e-3, 1), 3);
        fmi2::fmi2FreeInstance(null_mut());
        assert_eq!(fmi2::fmi2GetReal(made, null(), 0, null_mut()), 0);
        assert_eq!(fmi2::fmi2GetReal(made, null(), 1, null_mut()), 3);
        assert_eq!(fmi2::fmi2SetFMUstate(made, null_mut()), 3);
        assert_eq!(fmi2::fmi2FreeFMUstate(made, null_mut()), 0);
        fmi2::fmi2FreeInstance(made);
    }
    let nothing = Kept::default();
    assert!(Instance::open("/nowhere", "", &nothing).is_none());
    assert!(
        nothing.0.borrow()[0]
            .1
            .starts_with("the model of the FMU cannot be read: ")
    );
}
