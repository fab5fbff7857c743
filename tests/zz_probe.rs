mod common;
use common::*;
use longdrive::{Outcome, derivative, Drive};
#[test] fn probe() {
  for step in [0.02,0.01,0.005,0.004,0.0025,0.002,0.001] {
  let mut all=vec![]; let mut vals=vec![]; let mut hess=vec![];
  for file in ["reference_drives.json"] {
  for drive in data(file)["drives"].as_array().unwrap() {
    let mut setup = setup(drive["setup"].as_object().unwrap()); setup.flight.step=step;
    let d=Drive::new(&setup).unwrap();
    for o in Outcome::ALL { let e=drive["outcomes"][o.name()].as_f64().unwrap(); if e.abs()>1e-9 && *o!=Outcome::SpinAxis { vals.push(((o.value(&d).unwrap()-e).abs()/e.abs(), format!("{} {}",drive["name"],o.name()))); } }
    for of in [Outcome::Carry, Outcome::Lateral] {
      let theirs = drive["gradient"][of.name()].as_object().unwrap();
      let wrt: Vec<_> = theirs.keys().map(|n| setup.variable(n).unwrap()).collect();
      let ours = derivative::gradient(&setup, of, &wrt).unwrap();
      for (p,d) in wrt.iter().zip(ours.gradient) { let e=theirs[p.name].as_f64().unwrap(); if e.abs()>1e-7 { all.push(((d-e).abs()/e.abs(), format!("{} d {}/d {} = {e}",drive["name"],of.name(),p.name))); } }
      if let serde_json::Value::Array(h)=&drive[format!("hessian_{}_loft_attack", of.name())] {
        let w=["club.loft","swing.attack_angle"].map(|n| setup.variable(n).unwrap());
        let o=derivative::hessian(&setup,of,&w).unwrap().hessian;
        for i in 0..2 {for j in 0..2 { let e=h[i][j].as_f64().unwrap(); if e.abs()>1e-7 {hess.push(((o[i][j]-e).abs()/e.abs(), format!("{} H{i}{j} {e}",drive["name"])));}}}
      }
    }
  }}
  for (n,v) in [("val",&mut vals),("grad",&mut all),("hess",&mut hess)] { v.sort_by(|a,b| b.0.total_cmp(&a.0)); println!("step {step} {n}: {:?}", &v[..3]); }
  }
}
