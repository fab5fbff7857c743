// SPDX-License-Identifier: MIT OR Apache-2.0
//
// Independent quad-precision oracle of the golf-drive model (impact, flight, landing).
//
// build:  g++ -O2 -std=gnu++17 -o oracle oracle.cpp -lquadmath
// run:    ./oracle check reference_drives.json      compare with another computation, values to Hessians
//         ./oracle write independent_drives.json    compute the drives below and write them
//         ./oracle write some.json e_t           only the drives whose names contain "e_t"
//         ./oracle list                             values only: one line for each drive
//
// Values: impact from the 3x3 impulse system (checked against Winfield & Tan's full 15x15 system), flight by
// order-24 Gragg-Bulirsch-Stoer extrapolation, events by Newton on the length of the step that holds them.
// Derivatives: central differences in three step sizes with two Richardson extrapolations (order 6).
#include <cmath>
#include <cstdio>
#include <cstring>

#include "json.hpp"
#include "model.hpp"

// ---------------------------------------------------------------- derivatives
/// Scale of a parameter's step: its size, but at least a typical size of its kind.
static Q scale_of(const std::string& name, Q value) {
    auto starts = [&](const char* p) { return name.compare(0, strlen(p), p) == 0; };
    double typical = 0;
    if (starts("swing.closure")) typical = 1;
    else if (name == "swing.speed") typical = 10;
    else if (starts("swing.") || name == "club.loft") typical = 0.05;
    else if (starts("strike.")) typical = 0.003;
    else if (starts("club.inertia")) typical = 3e-5;
    else if (name == "air.density") typical = 0.3;
    else if (name == "aero.spin_decay") typical = 0.05;
    else if (starts("wind.up") || starts("wind.right") || starts("wind.downrange")) typical = 1;
    else if (name == "ground.height") typical = 1;
    else if (starts("impact.")) typical = 0.03;
    const Q a = fabsq(value);
    if (a < typical) return typical;
    return a > 0 ? a : Q(1e-3);
}

/// Differences of two outcomes; the spin axis' angle is taken the short way round.
static Q difference(int outcome, Q a, Q b) {
    Q d = a - b;
    if (outcome == SPIN_AXIS) d -= 2 * M_PIq * rintq(d / (2 * M_PIq));
    return d;
}

/// Two Richardson steps on central differences of step h, h/2, h/4; returns the order-6 value, and in `err` its
/// distance from the better order-4 one.
static Q richardson(const Q d[3], Q& err) {
    const Q a = (4 * d[1] - d[0]) / 3, b = (4 * d[2] - d[1]) / 3, c = (16 * b - a) / 15;
    err = fabsq(c - b);
    return c;
}

using Values = std::array<Q, N_SCALARS>;

static Values at(const Setup& s, const Numerics& num, std::initializer_list<std::pair<const char*, Q>> moves) {
    Setup t = s;
    for (auto& m : moves) t.p[m.first].value += m.second;
    return drive(t, num).x;
}

struct Gradient { std::vector<std::string> names; std::vector<Values> d, err; };

static Gradient gradient(const Setup& s, const Numerics& num, Q rel_step = 4e-8Q) {
    Gradient g;
    for (auto& name : s.order) {
        if (!s.has(name)) continue;
        const Q h0 = rel_step * scale_of(name, s.num(name));
        Q d[3][N_SCALARS];
        for (int l = 0; l < 3; ++l) {
            const Q h = h0 / (1 << l);
            const Values p = at(s, num, {{name.c_str(), h}}), m = at(s, num, {{name.c_str(), -h}});
            for (int k = 0; k < N_SCALARS; ++k) d[l][k] = difference(k, p[k], m[k]) / (2 * h);
        }
        Values v, e;
        for (int k = 0; k < N_SCALARS; ++k) {
            const Q t[3] = {d[0][k], d[1][k], d[2][k]};
            v[k] = richardson(t, e[k]);
        }
        g.names.push_back(name); g.d.push_back(v); g.err.push_back(e);
    }
    return g;
}

/// h[i][j] = second derivatives of all outcomes by names i and j.
using Hessian = std::vector<std::vector<Values>>;

static Hessian hessian(const Setup& s, const std::vector<std::string>& names, const Numerics& num, Hessian& err, Q rel_step = 4e-6Q) {
    const size_t n = names.size();
    Hessian H(n, std::vector<Values>(n));
    err = H;
    const Values c = drive(s, num).x;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) {
            const Q hi = rel_step * scale_of(names[i], s.num(names[i])), hj = rel_step * scale_of(names[j], s.num(names[j]));
            Q d[3][N_SCALARS];
            for (int l = 0; l < 3; ++l) {
                const Q a = hi / (1 << l), b = hj / (1 << l);
                const char *ni = names[i].c_str(), *nj = names[j].c_str();
                if (i == j) {
                    const Values p = at(s, num, {{ni, a}}), m = at(s, num, {{ni, -a}});
                    for (int k = 0; k < N_SCALARS; ++k) d[l][k] = (difference(k, p[k], c[k]) - difference(k, c[k], m[k])) / (a * a);
                } else {
                    const Values pp = at(s, num, {{ni, a}, {nj, b}}), pm = at(s, num, {{ni, a}, {nj, -b}});
                    const Values mp = at(s, num, {{ni, -a}, {nj, b}}), mm = at(s, num, {{ni, -a}, {nj, -b}});
                    for (int k = 0; k < N_SCALARS; ++k) d[l][k] = (difference(k, pp[k], pm[k]) - difference(k, mp[k], mm[k])) / (4 * a * b);
                }
            }
            for (int k = 0; k < N_SCALARS; ++k) {
                const Q t[3] = {d[0][k], d[1][k], d[2][k]};
                H[i][j][k] = H[j][i][k] = richardson(t, err[i][j][k]);
                err[j][i][k] = err[i][j][k];
            }
        }
    return H;
}

// ---------------------------------------------------------------- text
static std::string text(Q v) {  // 17 significant digits, no negative zero
    if (v == 0) return "0.0";
    char b[64];
    quadmath_snprintf(b, sizeof b, "%.17Qg", v);
    return b;
}
static std::string short_text(double v) {  // the shortest decimal that reads back as v
    char b[64];
    for (int p = 1; p <= 17; ++p) {
        snprintf(b, sizeof b, "%.*g", p, v);
        if (strtod(b, nullptr) == v) break;
    }
    if (!strpbrk(b, ".e")) strcat(b, ".0");
    return b;
}
static std::string sci(Q v) {
    char b[64];
    snprintf(b, sizeof b, "%.1e", (double)v);
    return b;
}

// ---------------------------------------------------------------- the drives
/// splitmix64: a fixed sequence, the same everywhere.
struct Rng {
    uint64_t s;
    double unit() {
        uint64_t z = (s += 0x9e3779b97f4a7c15ull);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return ((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    /// Uniform in [a, b], rounded to a short decimal (5 significant digits).
    double in(double a, double b) {
        char t[40];
        snprintf(t, sizeof t, "%.5g", a + (b - a) * unit());
        return strtod(t, nullptr);
    }
    /// An angle in radians, uniform between a and b degrees.
    double deg(double a, double b) { return in(a * M_PI / 180, b * M_PI / 180); }
};

static void set_law(Setup& s, const std::string& law, Rng& r, double jitter) {
    s.law = law;
    auto put = [&](const char* n, double v) { s.set(std::string("aero.") + n, jitter ? r.in(v * (1 - jitter), v * (1 + jitter)) : v); };
    if (law == "robinson") { put("cd0", .3); put("cd1", 2.58e-4); put("cl_max", .319); put("cl_rate", 2.48e-3); }
    else if (law == "linear") { put("cd", .25); put("cl_slope", 1.2); }
    else if (law == "smits-smith") { put("cd1", .24); put("cd2", .18); put("cd3", .06); put("re1", 9e4); put("re2", 2e5); put("cl1", .54); put("cl_exp", .4); }
    else if (law == "ferguson") { put("cd0", .1304); put("cd1", .9287); put("cd2", -.8259); put("cl0", .0504); put("cl1", 1.2031); put("cl2", -1.1490); }
    else if (law == "macdonald-hanzely") { put("cd_speed", 14.0208); put("cl_speed", 10.18032); }
    else if (law == "naruo-mizota") {
        put("cd0", .2049); put("cd1", .2148); put("cd2", 1.098); put("cd3", -1.760); put("cd4", .7510);
        put("cl0", .0616); put("cl1", 1.250); put("cl2", -1.644); put("cl3", 1.006); put("cl4", -.2158);
    }
    else if (law == "lyu") {
        put("cd_low0", 1.50); put("cd_low1", -2.59); put("cd_low2", 1.29); put("cd_high0", .56); put("cd_high1", -.540); put("cd_high2", .191);
        put("cl1", 1.99); put("cl2", -3.25);
    }
    else if (law == "usga-itr") {
        put("cd0", .2028); put("cd1", -.2159); put("cd2", 2.8466); put("cd_re", .0165);
        put("cl0", .0860); put("cl1", .6463); put("cl2", 1.4789); put("cl_re", -.0122);
    }
    else if (law != "launch-monitor") { fprintf(stderr, "set_law: no law %s\n", law.c_str()); exit(2); }
    else { put("cd0", .14972); put("cd1", .79237); put("cd2", -.18328); put("cd_re", -.00201); put("s_cap", .6); put("cl_max", .56282); put("cl_rate", 4.52866); }
}

/// A random, thoroughly three-dimensional drive; loft between the two bounds (degrees).
static Setup random_setup(Rng& r, const std::string& law, double loft_lo, double loft_hi, double jitter = 0.03) {
    Setup s;
    const bool wedge = loft_lo > 25;
    s.set("swing.speed", wedge ? r.in(33, 40) : r.in(40, 53));
    s.set("swing.attack_angle", wedge ? r.deg(-6, -1) : r.deg(-3, 6));
    s.set("swing.path", r.deg(-5, 5));
    s.set("swing.face_angle", r.deg(-4, 4));
    s.set("swing.shaft_lean", r.deg(-2, 3));
    for (auto c : {"x", "y", "z"}) s.set(std::string("swing.closure.") + c, c[0] == 'x' ? r.in(15, 45) : r.in(-12, 12));
    s.set("strike.high", r.in(-.009, .012));
    s.set("strike.toe", r.in(-.016, .018));
    s.set("club.mass", wedge ? r.in(.27, .31) : r.in(.19, .24));
    s.set("club.loft", r.deg(loft_lo, loft_hi));
    s.set("club.inertia.xx", r.in(3.2e-4, 5.6e-4));
    s.set("club.inertia.yy", r.in(2.0e-4, 4.1e-4));
    s.set("club.inertia.zz", r.in(2.4e-4, 3.6e-4));
    s.set("club.inertia.xy", r.in(-6e-5, 6e-5));
    s.set("club.inertia.xz", r.in(-8e-5, 8e-5));
    s.set("club.inertia.yz", r.in(-6e-5, 6e-5));
    s.set("club.cg_depth", wedge ? r.in(.008, .016) : r.in(.028, .043));
    s.set("club.bulge_radius", r.in(.24, .42));
    s.set("club.roll_radius", r.in(.22, .40));
    s.set("club.face_semi_axis", r.in(.16, .42));
    s.set("ball.mass", r.in(.0448, .0464));
    s.set("ball.radius", r.in(.02110, .02150));
    s.set("ball.inertia", r.in(7.8e-6, 8.9e-6));
    s.set("impact.restitution", wedge ? r.in(.66, .74) : r.in(.74, .86));
    s.set("impact.tangential_restitution", 0);
    s.null("impact.friction");
    s.set("air.density", r.in(1.02, 1.28));
    s.set("air.viscosity", r.in(1.72e-5, 1.88e-5));
    s.set("gravity", r.in(9.78, 9.83));
    s.set("wind.up", r.in(-.8, .8));
    s.set("wind.right", r.in(-6, 6));
    s.set("wind.downrange", r.in(-7, 7));
    s.null("wind.roughness");
    s.set("wind.reference_height", 10);
    s.set("ground.height", 0);
    s.set("aero.spin_decay", r.in(.03, .3));
    s.null("aero.spin_damping");
    set_law(s, law, r, jitter);
    return s;
}

struct Named { std::string name; Setup s; };

static std::vector<Named> drives() {
    std::vector<Named> out;
    auto add = [&](const std::string& name, const Setup& s) { out.push_back({name, s}); };
    const double deg = M_PI / 180;
    auto rounded = [](double v) { char t[40]; snprintf(t, sizeof t, "%.6g", v); return strtod(t, nullptr); };

    uint64_t seed = 20240601;
    auto rng = [&] { return Rng{seed++}; };
    // Each law twice: first with its own coefficients, and slip at exit (e_t < 0); then with
    // perturbed coefficients, and no slip at exit.
    const char* laws[] = {"robinson", "linear", "smits-smith", "ferguson", "launch-monitor"};
    for (int i = 0; i < 5; ++i) {
        Rng r = rng();
        Setup s = random_setup(r, laws[i], 10, 17, 0);
        s.set("impact.tangential_restitution", r.in(-.20, -.10));
        add(std::string("3-D ") + laws[i] + ", e_t < 0", s);
        Rng r2 = rng();
        // The lofts of these second drives increase from law to law, from a driver to a wedge.
        const double lo[] = {9, 20, 28, 36, 46}, hi[] = {12, 24, 32, 40, 50};
        s = random_setup(r2, laws[i], lo[i], hi[i]);
        if (i == 3) s.set("impact.friction", .6);  // given, but never reached
        add(std::string("3-D ") + laws[i] + (i == 3 ? ", friction given but sticking" : ", rolling at exit"), s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "launch-monitor", 9, 12);
        s.set("aero.spin_decay", 0); s.set("aero.spin_damping", 2e-5);
        add("kappa 2e-5, launch-monitor", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "ferguson", 22, 28);
        s.set("aero.spin_decay", 0); s.set("aero.spin_damping", 2e-5); s.set("impact.tangential_restitution", -.12);
        add("kappa 2e-5, ferguson, e_t < 0", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "launch-monitor", 10, 13);
        s.set("wind.roughness", .01); s.set("wind.right", 4.3); s.set("wind.downrange", -5.2); s.set("wind.up", .3);
        add("log wind, z0 0.01", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "smits-smith", 12, 16);
        s.set("wind.roughness", .03); s.set("wind.reference_height", 8); s.set("wind.right", -3.7); s.set("wind.downrange", 6.1);
        s.set("wind.up", -.2); s.set("ground.height", 3);
        add("log wind, z0 0.03, reference 8 m, ground 3 m above", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "linear", 17, 20);
        s.set("impact.friction", .05);
        add("slip, mu 0.05", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "launch-monitor", 50, 50);
        s.set("club.loft", rounded(50 * deg)); s.set("impact.friction", .1); s.set("impact.tangential_restitution", -.15);
        add("slip, mu 0.1, loft 50, e_t < 0", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "robinson", 11, 15);
        s.set("club.mass", .06);
        for (auto c : {"xx", "yy", "zz", "xy", "xz", "yz"}) {
            const std::string n = std::string("club.inertia.") + c;
            s.set(n, rounded((double)s.num(n) * .3));
        }
        add("60 g head", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "ferguson", 11, 15);
        s.set("club.mass", 1.9);
        for (auto c : {"xx", "yy", "zz", "xy", "xz", "yz"}) {
            const std::string n = std::string("club.inertia.") + c;
            s.set(n, rounded((double)s.num(n) * 9));
        }
        add("1.9 kg head", s);
    }
    for (auto law : {"linear", "launch-monitor"}) {
        Rng r = rng(); Setup s = random_setup(r, law, 10, 12);
        s.set("club.loft", rounded(-3 * deg)); s.set("swing.attack_angle", rounded(15 * deg)); s.set("swing.shaft_lean", rounded(-.5 * deg));
        s.set("strike.high", -.002); s.set("strike.toe", .004);
        add(std::string("negative loft, ") + law, s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "launch-monitor", 9, 14);
        s.set("air.density", 0);
        add("vacuum", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "smits-smith", 10, 14);
        s.null("ball.inertia"); s.null("club.face_semi_axis"); s.set("impact.tangential_restitution", -.14);
        add("defaults: ball.inertia and face_semi_axis null", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "ferguson", 10, 14);
        s.inf("club.bulge_radius"); s.set("club.roll_radius", .3); s.null("club.face_semi_axis");
        s.set("strike.high", .008); s.set("strike.toe", -.011);
        add("bulge inf, roll 0.3 m, semi-axis null", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "linear", 10, 14);
        s.inf("club.bulge_radius"); s.set("club.roll_radius", .3); s.set("club.face_semi_axis", .25);
        s.set("strike.high", -.007); s.set("strike.toe", .012);
        add("bulge inf, roll 0.3 m, semi-axis given", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "robinson", 5, 5);
        s.set("club.loft", rounded(5 * deg)); s.set("swing.attack_angle", rounded(-8 * deg)); s.set("swing.shaft_lean", 0);
        s.set("strike.high", -.001); s.set("ground.height", -20);
        add("launched downward, ground 20 m below", s);
    }
    {
        // The same launch with more lift: it dips, then climbs above the tee.
        Rng r = rng(); Setup s = random_setup(r, "launch-monitor", 11, 11, 0);
        s.set("club.loft", rounded(11 * deg)); s.set("swing.attack_angle", rounded(-12 * deg)); s.set("swing.shaft_lean", 0);
        s.set("swing.speed", 60); s.set("strike.high", -.002); s.set("strike.toe", .003); s.set("ground.height", -20);
        s.set("wind.downrange", -9); s.set("wind.up", .7);
        add("launched downward, climbs above the tee", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "smits-smith", 1, 1, 0);
        s.set("club.loft", rounded(.02 * deg)); s.set("swing.attack_angle", rounded(12 * deg)); s.set("swing.shaft_lean", 0);
        s.set("swing.path", 0); s.set("swing.face_angle", rounded(.01 * deg));
        s.set("swing.closure.x", .02); s.set("swing.closure.y", -.03); s.set("swing.closure.z", .01);
        s.set("strike.high", 2e-5); s.set("strike.toe", -3e-5); s.set("wind.downrange", 1.5); s.set("wind.right", 2); s.set("wind.up", .1);
        add("nearly no spin, smits-smith (s < 0.001)", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "ferguson", 1, 1, 0);
        s.set("club.loft", rounded(.6 * deg)); s.set("swing.attack_angle", rounded(12 * deg)); s.set("swing.shaft_lean", 0);
        s.set("swing.path", rounded(.1 * deg)); s.set("swing.face_angle", 0);
        s.set("swing.closure.x", .4); s.set("swing.closure.y", .3); s.set("swing.closure.z", -.2);
        s.set("strike.high", -2e-4); s.set("strike.toe", 4e-4); s.set("wind.downrange", -2); s.set("wind.right", -1); s.set("wind.up", .1);
        add("nearly no spin, ferguson (s < 0.02)", s);
    }
    {
        // The spin decays through the joint of the law's two pieces, once.
        Rng r = rng(); Setup s = random_setup(r, "smits-smith", 12, 15, 0);
        s.set("aero.spin_decay", 1.3); s.set("wind.up", 0);
        add("smits-smith, s falls through 0.001", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "ferguson", 12, 15, 0);
        s.set("aero.spin_decay", .6);
        add("ferguson, s falls through 0.02", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "launch-monitor", 10, 14);
        s.set("gravity", 1.62); s.set("air.density", .05);
        add("moon gravity, thin air", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "linear", 11, 15);
        s.set("wind.downrange", 25); s.set("wind.right", 0); s.set("wind.up", 0);
        add("tail wind 25 m/s", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "smits-smith", 10, 14);
        s.set("impact.restitution", 1); s.set("impact.tangential_restitution", -.16);
        add("restitution 1", s);
    }
    {
        Rng r = rng(); Setup s = random_setup(r, "launch-monitor", 14, 18);
        s.set("impact.restitution", .05);
        add("restitution 0.05", s);
    }
    for (auto law : {"macdonald-hanzely", "naruo-mizota", "lyu", "usga-itr"}) {
        Rng r = rng(); Setup s = random_setup(r, law, 8, 10, 0);
        s.set("impact.tangential_restitution", r.in(-.20, -.10));
        add(std::string("3-D ") + law + ", e_t < 0", s);
    }
    for (auto law : {"naruo-mizota", "usga-itr"}) {
        Rng r = rng(); Setup s = random_setup(r, law, 8, 10, .01);
        s.set("aero.spin_decay", .6);
        add(std::string(law) + ", s falls through its smoothing", s);
    }
    return out;
}

// ---------------------------------------------------------------- commands
static const std::vector<std::string> HESSIAN_NAMES = {"club.loft", "swing.attack_angle", "swing.speed", "strike.toe", "air.density", "club.cg_depth"};
static const int HESSIAN_OF[] = {CARRY, LATERAL, APEX_HEIGHT, FLIGHT_TIME};

/// Other numerics, which measure the errors of the values: lower order, shorter steps, another
/// tolerance.
static Numerics other_numerics() { Numerics n; n.columns = 9; n.tol = 1e-29Q; n.h_max = 0.11Q; return n; }

static Q relative(Q a, Q b, Q floor) { return fabsq(a - b) / fmaxq(fabsq(b), floor); }

static int list() {
    for (auto& d : drives()) {
        const Drive o = drive(d.s);
        const Drive p = drive(d.s, other_numerics());
        Q worst = 0;
        for (int k = 0; k < N_SCALARS; ++k) worst = fmaxq(worst, relative(p.x[k], o.x[k], 1e-3Q));
        printf("%-52s carry %8.3f lat %8.3f t %6.3f apex %7.3f @%6.3f desc %5.1f deg | v %5.1f la %5.1f ld %5.1f spin %6.1f back %7.1f side %7.1f | s %.4f..%.4f%s%s steps %d other %s 15x15 %s\n",
               d.name.c_str(), (double)o.x[CARRY], (double)o.x[LATERAL], (double)o.x[FLIGHT_TIME], (double)o.x[APEX_HEIGHT], (double)o.x[APEX_TIME],
               (double)o.x[DESCENT] * 180 / M_PI, (double)o.x[BALL_SPEED], (double)o.x[LAUNCH_ANGLE] * 180 / M_PI, (double)o.x[LAUNCH_DIRECTION] * 180 / M_PI,
               (double)o.x[SPIN], (double)o.x[BACKSPIN], (double)o.x[SIDESPIN], (double)o.s_min, (double)o.s_max,
               o.crossings ? " CROSSES s0" : "", o.hit.slipped ? " slipped" : "", o.steps, sci(worst).c_str(),
               o.hit.slipped ? "-" : sci(full_system_disagreement(d.s, o.hit)).c_str());
        // The tensor must be positive definite.
        auto n = [&](const char* c) { return d.s.num(std::string("club.inertia.") + c); };
        const Q a = n("xx"), b = n("yy"), c = n("zz"), xy = n("xy"), xz = n("xz"), yz = n("yz");
        if (!(a > 0 && a * b > xy * xy && a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz) > 0)) printf("   INERTIA NOT POSITIVE DEFINITE\n");
    }
    return 0;
}

/// Writes all drives, or only the drives whose names contain a text.
static int write(const char* path, const std::string& part = "") {
    FILE* f = fopen(path, "w");
    if (!f) { perror(path); return 1; }
    fprintf(f, "{\n \"about\": \"Independent computation in quad precision (113 bits): SI and radians, tensor entries for inertia. Parameters are the doubles "
               "nearest to the decimals here; null: unset, its default applies; inf: flat. Gradients by every finite parameter (total derivatives through defaults), "
               "Hessians over six. 17 significant digits; gradients below 1e-18 and second derivatives below 1e-12 are rounding and written as 0. Source: oracle.cpp.\",\n \"drives\": [");
    Q worst_value = 0, worst_grad = 0, worst_hess = 0, worst_15 = 0, snapped = 0, smallest = 1e30Q, worst_grad_n = 0, worst_hess_n = 0;
    const Numerics num, other = other_numerics();
    bool first_drive = true;
    auto clean = [&](Q v) {
        if (fabsq(v) < 1e-18Q) { snapped = fmaxq(snapped, fabsq(v)); return Q(0); }
        smallest = fminq(smallest, fabsq(v));
        return v;
    };
    for (auto& d : drives()) {
        if (d.name.find(part) == std::string::npos) continue;
        const Drive o = drive(d.s, num), o2 = drive(d.s, other);
        Q dv = 0, dg = 0, dh = 0, dgn = 0, dhn = 0, d15 = 0;
        for (int k = 0; k < N_SCALARS; ++k) dv = fmaxq(dv, relative(o2.x[k], o.x[k], 1e-6Q));
        if (!o.hit.slipped) d15 = full_system_disagreement(d.s, o.hit);
        fprintf(f, "%s\n  {\n   \"name\": \"%s\",\n   \"setup\": {", first_drive ? "" : ",", d.name.c_str());
        first_drive = false;
        bool law_done = false;
        for (size_t i = 0; i < d.s.order.size(); ++i) {
            const std::string& n = d.s.order[i];
            const Param& p = d.s.p.at(n);
            fprintf(f, "%s\n    \"%s\": %s", i ? "," : "", n.c_str(),
                    p.kind == Param::Null ? "null" : p.kind == Param::Inf ? "\"inf\"" : short_text((double)p.value).c_str());
            if (n == "aero.spin_damping") { fprintf(f, ",\n    \"aero.law\": \"%s\"", d.s.law.c_str()); law_done = true; }
        }
        if (!law_done) throw std::runtime_error("law not written");
        fprintf(f, "\n   },\n   \"outcomes\": {\n    \"status\": \"landed\"");
        for (int k = 0; k < N_SCALARS; ++k) fprintf(f, ",\n    \"%s\": %s", SCALARS[k], text(o.x[k]).c_str());
        auto vec = [&](const char* n, V3 v) { fprintf(f, ",\n    \"%s\": [%s, %s, %s]", n, text(v.x).c_str(), text(v.y).c_str(), text(v.z).c_str()); };
        vec("ball_velocity", o.hit.v); vec("ball_spin", o.hit.w); vec("club_velocity_after", o.hit.club_v); vec("club_spin_after", o.hit.club_w);
        vec("impulse", o.hit.J); vec("face_normal", o.hit.n); vec("contact_point", o.hit.r);
        fprintf(f, ",\n    \"slipped\": %s\n   },\n   \"gradient\": {", o.hit.slipped ? "true" : "false");
        // Gradients, twice: with these numerics and with others and another step, which measures all errors at once.
        const Gradient g = gradient(d.s, num), g2 = gradient(d.s, other, 1.7e-8Q);
        for (int k = 0; k < N_SCALARS; ++k) {
            fprintf(f, "%s\n    \"%s\": {", k ? "," : "", SCALARS[k]);
            for (size_t i = 0; i < g.names.size(); ++i) {
                fprintf(f, "%s\n     \"%s\": %s", i ? "," : "", g.names[i].c_str(), text(clean(g.d[i][k])).c_str());
                const Q scale = scale_of(g.names[i], d.s.num(g.names[i]));
                const Q e = fmaxq(g.err[i][k], fabsq(g2.d[i][k] - g.d[i][k]));
                if (fabsq(g.d[i][k]) > 1e-18Q) dg = fmaxq(dg, e / fabsq(g.d[i][k]));
                dgn = fmaxq(dgn, e * scale / fmaxq(fabsq(o.x[k]), 1e-3Q));
            }
            fprintf(f, "\n    }");
        }
        fprintf(f, "\n   },\n   \"hessian\": {\n    \"names\": [");
        for (size_t i = 0; i < HESSIAN_NAMES.size(); ++i) fprintf(f, "%s\"%s\"", i ? ", " : "", HESSIAN_NAMES[i].c_str());
        fprintf(f, "]");
        Hessian err, err2;
        const Hessian H = hessian(d.s, HESSIAN_NAMES, num, err), H2 = hessian(d.s, HESSIAN_NAMES, other, err2, 1e-6Q);
        for (int k : HESSIAN_OF) {
            fprintf(f, ",\n    \"%s\": [", SCALARS[k]);
            for (size_t i = 0; i < H.size(); ++i) {
                fprintf(f, "%s\n     [", i ? "," : "");
                for (size_t j = 0; j < H.size(); ++j) {
                    fprintf(f, "%s%s", j ? ", " : "", text(fabsq(H[i][j][k]) < 1e-12Q ? Q(0) : H[i][j][k]).c_str());
                    const Q si = scale_of(HESSIAN_NAMES[i], d.s.num(HESSIAN_NAMES[i])), sj = scale_of(HESSIAN_NAMES[j], d.s.num(HESSIAN_NAMES[j]));
                    const Q e = fmaxq(err[i][j][k], fabsq(H2[i][j][k] - H[i][j][k]));
                    if (fabsq(H[i][j][k]) > 1e-12Q) dh = fmaxq(dh, e / fabsq(H[i][j][k]));
                    else snapped = fmaxq(snapped, fabsq(H[i][j][k]));
                    dhn = fmaxq(dhn, e * si * sj / fmaxq(fabsq(o.x[k]), 1e-3Q));
                }
                fprintf(f, "]");
            }
            fprintf(f, "\n    ]");
        }
        fprintf(f, "\n   }\n  }");
        fflush(f);
        printf("%-52s value %s  gradient rel %s scaled %s  hessian rel %s scaled %s  15x15 %s%s\n", d.name.c_str(), sci(dv).c_str(), sci(dg).c_str(), sci(dgn).c_str(),
               sci(dh).c_str(), sci(dhn).c_str(), o.hit.slipped ? "(slip)" : sci(d15).c_str(), o.crossings ? " CROSSES s0" : "");
        fflush(stdout);
        worst_value = fmaxq(worst_value, dv); worst_grad = fmaxq(worst_grad, dg); worst_hess = fmaxq(worst_hess, dh); worst_15 = fmaxq(worst_15, d15);
        worst_grad_n = fmaxq(worst_grad_n, dgn); worst_hess_n = fmaxq(worst_hess_n, dhn);
    }
    fprintf(f, "\n ]\n}\n");
    fclose(f);
    printf("worst: value %s  gradient rel %s scaled %s  hessian rel %s scaled %s  15x15 %s; largest derivative written as 0: %s, smallest kept gradient: %s\n",
           sci(worst_value).c_str(), sci(worst_grad).c_str(), sci(worst_grad_n).c_str(), sci(worst_hess).c_str(), sci(worst_hess_n).c_str(), sci(worst_15).c_str(),
           sci(snapped).c_str(), sci(smallest).c_str());
    return 0;
}

static Setup setup_of(const Json& j) {
    Setup s;
    for (auto& m : j.members) {
        if (m.first == "aero.law") s.law = m.second.str;
        else if (m.second.kind == Json::Number) s.set(m.first, m.second.num);
        else if (m.second.kind == Json::Null) s.null(m.first);
        else if (m.second.kind == Json::String && m.second.str == "inf") s.inf(m.first);
        else throw std::runtime_error("setup: " + m.first);
    }
    return s;
}

static int check(const char* path) {
    const Json ref = read_json(path);
    const Numerics num;
    // The relative difference; for tiny references (zeros) the absolute difference, reported apart.
    struct Tally { Q rel = 0, abs = 0; std::string where; };
    auto compare = [](Tally& t, Q mine, double theirs, const std::string& what, double tiny) {
        if (fabs(theirs) <= tiny) { t.abs = fmaxq(t.abs, fabsq(mine - Q(theirs))); return; }
        const Q r = fabsq(mine - Q(theirs)) / fabsq(Q(theirs));
        if (r > t.rel) { t.rel = r; t.where = what; }
    };
    Q w15 = 0;
    for (auto& d : ref["drives"].items) {
        const Setup s = setup_of(d["setup"]);
        const Drive o = drive(s, num);
        Tally tv, tg, th;
        const Json& out = d["outcomes"];
        for (int k = 0; k < N_SCALARS; ++k) {
            if (!out.find(SCALARS[k])) continue;
            const double r = out[SCALARS[k]].num;
            compare(tv, r + difference(k, o.x[k], r), r, SCALARS[k], 1e-9);
        }
        auto vec = [&](const char* n, V3 v) {
            const Json* j = out.find(n);
            if (!j) return;
            const Q c[3] = {v.x, v.y, v.z};
            for (int i = 0; i < 3; ++i) compare(tv, c[i], (*j)[i].num, n, 1e-9);
        };
        vec("ball_velocity", o.hit.v); vec("ball_spin", o.hit.w); vec("club_velocity_after", o.hit.club_v); vec("club_spin_after", o.hit.club_w);
        vec("impulse", o.hit.J); vec("face_normal", o.hit.n); vec("contact_point", o.hit.r);
        if (out["slipped"].b != o.hit.slipped) printf("SLIP FLAG DIFFERS\n");
        const Gradient g = gradient(s, num);
        size_t compared = 0;
        for (int k = 0; k < N_SCALARS; ++k) {
            const Json* j = d["gradient"].find(SCALARS[k]);
            if (!j) continue;
            for (size_t i = 0; i < g.names.size(); ++i)
                if (auto* v = j->find(g.names[i])) { compare(tg, g.d[i][k], v->num, std::string(SCALARS[k]) + " by " + g.names[i], 1e-9); ++compared; }
        }
        if (d.find("hessian_carry_loft_attack")) {
            Hessian err;
            const Hessian H = hessian(s, {"club.loft", "swing.attack_angle"}, num, err);
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) {
                    compare(th, H[i][j][CARRY], d["hessian_carry_loft_attack"][i][j].num, "carry", 1e-6);
                    compare(th, H[i][j][LATERAL], d["hessian_lateral_loft_attack"][i][j].num, "lateral", 1e-6);
                }
        }
        const Q f15 = o.hit.slipped ? Q(0) : full_system_disagreement(s, o.hit);
        w15 = fmaxq(w15, f15);
        printf("%-40.40s values %s (%s; zeros %s)  gradient[%zu] %s (%s; zeros %s)  hessian %s (zeros %s)  15x15 %s%s\n", d["name"].str.c_str(), sci(tv.rel).c_str(), tv.where.c_str(),
               sci(tv.abs).c_str(), compared, sci(tg.rel).c_str(), tg.where.c_str(), sci(tg.abs).c_str(), sci(th.rel).c_str(), sci(th.abs).c_str(), sci(f15).c_str(),
               o.crossings ? " CROSSES s0" : "");
        fflush(stdout);
    }
    printf("15x15 against 3x3: %s\n", sci(w15).c_str());
    if (ref.find("optima"))
        for (auto& d : ref["optima"].items) {
            Setup s = setup_of(d["setup"]);
            for (size_t i = 0; i < d["variables"].items.size(); ++i) s.p[d["variables"][i].str].value = d["optimum"][i].num;
            const Drive o = drive(s, num);
            const Gradient g = gradient(s, num);
            printf("optimum %s: carry differs by %s;", d["name"].str.c_str(), sci(o.x[CARRY] - Q(d["carry"].num)).c_str());
            for (size_t i = 0; i < d["variables"].items.size(); ++i)
                for (size_t k = 0; k < g.names.size(); ++k)
                    if (g.names[k] == d["variables"][i].str)
                        printf(" d/d %s = %.12g (%s, multiplier %.12g)", g.names[k].c_str(), (double)g.d[k][CARRY], d["active"][i].str.c_str(), d["multipliers"][i].num);
            printf("\n");
        }
    return 0;
}

int main(int argc, char** argv) try {
    if (argc == 3 && !strcmp(argv[1], "check")) return check(argv[2]);
    if (argc == 3 && !strcmp(argv[1], "write")) return write(argv[2]);
    if (argc == 4 && !strcmp(argv[1], "write")) return write(argv[2], argv[3]);
    if (argc == 2 && !strcmp(argv[1], "list")) return list();
    fprintf(stderr, "usage: oracle check <reference.json> | write <out.json> [part of a name] | list\n");
    return 2;
} catch (const std::exception& e) {
    fprintf(stderr, "error: %s\n", e.what());
    return 1;
}
