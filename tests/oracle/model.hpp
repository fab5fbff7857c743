// SPDX-License-Identifier: MIT OR Apache-2.0
//
// Quad-precision model of one golf drive: delivery -> impact -> flight -> landing.
// Frame: X up, Y right, Z downrange (right-handed); SI units, radians.
// Everything is evaluated in __float128 (113-bit mantissa, about 34 digits).
#pragma once
#include <quadmath.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

using Q = __float128;

// ---------------------------------------------------------------- small linear algebra
struct V3 { Q x, y, z; };
inline V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V3 operator*(Q s, V3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline Q dot(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V3 cross(V3 a, V3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Q norm(V3 a) { return sqrtq(dot(a, a)); }

/// Solves a x = b by Gaussian elimination with row scaling and partial pivoting.
inline std::vector<Q> solve(std::vector<std::vector<Q>> a, std::vector<Q> b) {
    const size_t n = b.size();
    for (size_t i = 0; i < n; ++i) {
        Q big = 0;
        for (Q v : a[i]) big = fmaxq(big, fabsq(v));
        for (Q& v : a[i]) v /= big;
        b[i] /= big;
    }
    for (size_t c = 0; c < n; ++c) {
        size_t p = c;
        for (size_t r = c + 1; r < n; ++r)
            if (fabsq(a[r][c]) > fabsq(a[p][c])) p = r;
        std::swap(a[c], a[p]);
        std::swap(b[c], b[p]);
        if (a[c][c] == 0) throw std::runtime_error("singular system");
        for (size_t r = c + 1; r < n; ++r) {
            const Q f = a[r][c] / a[c][c];
            if (f == 0) continue;
            for (size_t k = c; k < n; ++k) a[r][k] -= f * a[c][k];
            b[r] -= f * b[c];
        }
    }
    std::vector<Q> x(n);
    for (size_t i = n; i-- > 0;) {
        Q s = b[i];
        for (size_t k = i + 1; k < n; ++k) s -= a[i][k] * x[k];
        x[i] = s / a[i][i];
    }
    return x;
}

// ---------------------------------------------------------------- parameters
/// One parameter: a finite number, unset (null: its default applies), or infinite (radii only).
struct Param {
    enum Kind { Number, Null, Inf } kind = Number;
    Q value = 0;
};

/// A drive's setup: parameters by dotted name, in the order they are written, plus the law's name.
struct Setup {
    std::string law;
    std::vector<std::string> order;
    std::map<std::string, Param> p;

    void put(const std::string& name, Param v) {
        if (!p.count(name)) order.push_back(name);
        p[name] = v;
    }
    void set(const std::string& name, double v) { put(name, {Param::Number, Q(v)}); }
    void null(const std::string& name) { put(name, {Param::Null, 0}); }
    void inf(const std::string& name) { put(name, {Param::Inf, 0}); }
    /// A parameter that must be a finite number.
    Q num(const std::string& name) const {
        auto it = p.find(name);
        if (it == p.end() || it->second.kind != Param::Number)
            throw std::runtime_error("parameter " + name + " is missing or not a number");
        return it->second.value;
    }
    /// A finite number, or `fallback` if unset or absent.
    Q opt(const std::string& name, Q fallback) const {
        auto it = p.find(name);
        return it == p.end() || it->second.kind != Param::Number ? fallback : it->second.value;
    }
    bool has(const std::string& name) const {
        auto it = p.find(name);
        return it != p.end() && it->second.kind == Param::Number;
    }
    /// 1/parameter, 0 for an infinite one.
    Q reciprocal(const std::string& name) const {
        auto it = p.find(name);
        if (it != p.end() && it->second.kind == Param::Inf) return 0;
        return 1 / num(name);
    }
};

// ---------------------------------------------------------------- impact
struct Impact {
    V3 n, r;                     ///< face normal at the impact point; that point from the head's centre of mass
    V3 J;                        ///< impulse on the ball
    V3 v, w, club_v, club_w;     ///< after impact
    bool slipped = false;
    V3 club_v0, club_w0;         ///< before impact
    std::array<std::array<Q, 3>, 3> inertia;  ///< the head's, in ground components
    Q ball_inertia;
};

/// Head's and face's axes, impact point and normal, and the 3x3 impulse solution.
inline Impact impact(const Setup& s) {
    Impact o;
    const Q V = s.num("swing.speed"), eps = s.num("swing.attack_angle"), chi = s.num("swing.path");
    const Q psi = s.num("swing.face_angle"), sig = s.num("swing.shaft_lean"), lam = s.num("club.loft");
    o.club_v0 = V * V3{sinq(eps), cosq(eps) * sinq(chi), cosq(eps) * cosq(chi)};
    o.club_w0 = {s.num("swing.closure.x"), s.num("swing.closure.y"), s.num("swing.closure.z")};

    const V3 I{1, 0, 0}, K{0, sinq(psi), cosq(psi)}, Jy{0, cosq(psi), -sinq(psi)};  // yawed ground axes
    const Q a = eps - sig, th = a + lam;
    const V3 Xh = cosq(a) * I - sinq(a) * K, Zh = cosq(a) * K + sinq(a) * I, Yh = Jy;
    const V3 fi = cosq(th) * I - sinq(th) * K, fk = cosq(th) * K + sinq(th) * I, fj = Jy;

    // Face ellipsoid, in a form that allows infinite radii.
    const Q r1 = s.num("strike.high"), r2 = s.num("strike.toe"), d = s.num("club.cg_depth");
    const Q cr = s.reciprocal("club.roll_radius"), cb = s.reciprocal("club.bulge_radius");
    const Q ck = s.has("club.face_semi_axis") ? 1 / s.num("club.face_semi_axis") : sqrtq(cr * cb);  // 1/P_k
    const Q q1 = r1 * r1 * cr + r2 * r2 * cb, q = q1 * ck;
    if (q >= 1) throw std::runtime_error("strike is off the face");
    const Q root = sqrtq(1 - q), r3 = d - q1 / (1 + root);
    o.r = r1 * fi + r2 * fj + r3 * fk;
    const V3 g = (r1 * cr) * fi + (r2 * cb) * fj + root * fk;
    o.n = (1 / norm(g)) * g;

    // Inertia tensor in ground components: sum over head axes of entry * (axis_a outer axis_b).
    const V3 ax[3] = {Xh, Yh, Zh};
    const Q xy = s.num("club.inertia.xy"), xz = s.num("club.inertia.xz"), yz = s.num("club.inertia.yz");
    const Q h[3][3] = {{s.num("club.inertia.xx"), xy, xz}, {xy, s.num("club.inertia.yy"), yz}, {xz, yz, s.num("club.inertia.zz")}};
    for (auto& row : o.inertia) row = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Q u[3] = {ax[i].x, ax[i].y, ax[i].z}, w[3] = {ax[j].x, ax[j].y, ax[j].z};
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) o.inertia[k][l] += h[i][j] * u[k] * w[l];
        }
    auto inv_inertia = [&](V3 b) {
        std::vector<std::vector<Q>> m(3, std::vector<Q>(3));
        for (int i = 0; i < 3; ++i) for (int j = 0; j < 3; ++j) m[i][j] = o.inertia[i][j];
        auto x = solve(m, {b.x, b.y, b.z});
        return V3{x[0], x[1], x[2]};
    };

    const Q M = s.num("club.mass"), m = s.num("ball.mass"), R = s.num("ball.radius");
    o.ball_inertia = s.opt("ball.inertia", 2 * m * R * R / 5);
    const Q e = s.num("impact.restitution"), et = s.opt("impact.tangential_restitution", 0);

    // K applied to an impulse J on the ball: the loss of contact-point velocity (club relative to ball).
    auto Kmul = [&](V3 J) {
        return (1 / M + 1 / m) * J - cross(o.r, inv_inertia(cross(o.r, J))) -
               (R * R / o.ball_inertia) * cross(o.n, cross(o.n, J));
    };
    const V3 u = o.club_v0 + cross(o.club_w0, o.r);
    const Q un = dot(o.n, u);
    const V3 rhs = u + (e * un) * o.n + et * (u - un * o.n);
    const V3 c0 = Kmul({1, 0, 0}), c1 = Kmul({0, 1, 0}), c2 = Kmul({0, 0, 1});
    auto J = solve({{c0.x, c1.x, c2.x}, {c0.y, c1.y, c2.y}, {c0.z, c1.z, c2.z}}, {rhs.x, rhs.y, rhs.z});
    o.J = {J[0], J[1], J[2]};
    if (s.has("impact.friction")) {
        const Q mu = s.num("impact.friction"), Jn = dot(o.n, o.J);
        const V3 Jt = o.J - Jn * o.n;
        const Q jt = norm(Jt);
        if (jt > mu * Jn) {
            o.slipped = true;
            const V3 dir = o.n + (mu / jt) * Jt;
            const Q den = dot(o.n, Kmul(dir));
            if (den <= 0) throw std::runtime_error("jammed contact");
            o.J = ((1 + e) * un / den) * dir;
        }
    }
    o.v = (1 / m) * o.J;
    o.w = (1 / o.ball_inertia) * cross(-R * o.n, o.J);
    o.club_v = o.club_v0 - (1 / M) * o.J;
    o.club_w = o.club_w0 - inv_inertia(cross(o.r, o.J));
    return o;
}

/// Solves Winfield & Tan's full system, 15 equations in u1..u12 and the impulse R on the club. Its
/// two no-slip rows have a tangential restitution, which is 0 in the paper. Returns the largest
/// difference from `o`, each vector relative to its own length (or to the spin or velocity scale if
/// it is tiny).
inline Q full_system_disagreement(const Setup& s, const Impact& o) {
    const Q M = s.num("club.mass"), m = s.num("ball.mass"), R = s.num("ball.radius"), Ib = o.ball_inertia;
    const Q e = s.num("impact.restitution"), et = s.opt("impact.tangential_restitution", 0);
    std::vector<std::vector<Q>> A(15, std::vector<Q>(15, Q(0)));
    std::vector<Q> b(15, Q(0));
    const Q v0[3] = {o.club_v0.x, o.club_v0.y, o.club_v0.z}, w0[3] = {o.club_w0.x, o.club_w0.y, o.club_w0.z};
    // [a]x as a matrix: (a x y)_i = sum_j skew(a)[i][j] y_j
    auto skew = [](V3 a) { return std::array<std::array<Q, 3>, 3>{{{0, -a.z, a.y}, {a.z, 0, -a.x}, {-a.y, a.x, 0}}}; };
    const V3 rb = -R * o.n;  // impact point from the ball's centre
    const auto sr = skew(o.r), sb = skew(rb);
    for (int i = 0; i < 3; ++i) {
        A[i][i] = M; A[i][12 + i] = -1; b[i] = M * v0[i];                 // M (V+ - V-) = R
        for (int j = 0; j < 3; ++j) {                                     // I_c (w+ - w-) = r x R
            A[3 + i][3 + j] = o.inertia[i][j];
            b[3 + i] += o.inertia[i][j] * w0[j];
            A[3 + i][12 + j] = -sr[i][j];
            A[9 + i][12 + j] = sb[i][j];                                  // I_b w_b+ = r_b x (-R)
        }
        A[6 + i][6 + i] = m; A[6 + i][12 + i] = 1;                        // m v_b+ = -R
        A[9 + i][9 + i] = Ib;
    }
    // Tangents: any orthonormal pair.
    V3 t1 = cross({0, 1, 0}, o.n);
    t1 = (1 / norm(t1)) * t1;
    const V3 t2 = cross(o.n, t1), va = o.club_v0 + cross(o.club_w0, o.r);
    const V3 dir[3] = {o.n, t1, t2};
    for (int k = 0; k < 3; ++k) {
        // dir . (V + w x r - v_b - w_b x r_b) = -coefficient * dir . approach
        const V3 g = dir[k], gr = cross(o.r, g), gb = cross(rb, g);
        const Q row[12] = {g.x, g.y, g.z, gr.x, gr.y, gr.z, -g.x, -g.y, -g.z, -gb.x, -gb.y, -gb.z};
        for (int c = 0; c < 12; ++c) A[12 + k][c] = row[c];
        b[12 + k] = -(k == 0 ? e : et) * dot(g, va);
    }
    const auto x = solve(A, b);
    const V3 got[5] = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}, {-x[12], -x[13], -x[14]}};
    const V3 want[5] = {o.club_v, o.club_w, o.v, o.w, o.J};
    Q worst = 0;
    for (int k = 0; k < 5; ++k) worst = fmaxq(worst, norm(got[k] - want[k]) / fmaxq(norm(want[k]), 1));
    return worst;
}

// ---------------------------------------------------------------- aerodynamics
/// a u + b u^2 + c u^3 with u = s/s0: the cubic through the origin that meets f at s0 with equal value and
/// first and second derivative; f0, f1, f2 = f, s0 f', s0^2 f'' there.
struct Cubic {
    Q a = 0, b = 0, c = 0;
    Cubic() = default;
    Cubic(Q f0, Q f1, Q f2) : c(f2 / 2 - f1 + f0) { b = f1 - f0 - 2 * c; a = f0 - b - c; }
    Q operator()(Q u) const { return u * (a + u * (b + u * c)); }
};

struct Aero {
    enum Law { Robinson, Linear, SmitsSmith, Ferguson, LaunchMonitor, MacdonaldHanzely, NaruoMizota, Lyu, UsgaItr } law;
    Q k[10] = {};
    Q s0 = 0;      ///< below it C_L is the cubic (0: never)
    Cubic low;
    mutable bool below = false;  ///< which branch to use; the flight switches it exactly at s = s0

    explicit Aero(const Setup& s) {
        auto load = [&](std::initializer_list<const char*> names) {
            int i = 0;
            for (auto n : names) k[i++] = s.num(std::string("aero.") + n);
        };
        if (s.law == "robinson") { law = Robinson; load({"cd0", "cd1", "cl_max", "cl_rate"}); }
        else if (s.law == "linear") { law = Linear; load({"cd", "cl_slope"}); }
        else if (s.law == "smits-smith") {
            law = SmitsSmith; load({"cd1", "cd2", "cd3", "re1", "re2", "cl1", "cl_exp"});
            s0 = 0.001Q;
            const Q f = k[5] * powq(s0, k[6]);
            low = Cubic(f, k[6] * f, k[6] * (k[6] - 1) * f);
        } else if (s.law == "ferguson") {
            law = Ferguson; load({"cd0", "cd1", "cd2", "cl0", "cl1", "cl2"});
            s0 = 0.02Q;
            low = Cubic(k[3] + s0 * (k[4] + s0 * k[5]), s0 * (k[4] + 2 * s0 * k[5]), 2 * s0 * s0 * k[5]);
        } else if (s.law == "launch-monitor") { law = LaunchMonitor; load({"cd0", "cd1", "cd2", "cd_re", "s_cap", "cl_max", "cl_rate"}); }
        else if (s.law == "macdonald-hanzely") {
            law = MacdonaldHanzely; load({"cd_speed", "cl_speed"});
            s0 = 0.02Q;
        } else if (s.law == "naruo-mizota") {
            law = NaruoMizota; load({"cd0", "cd1", "cd2", "cd3", "cd4", "cl0", "cl1", "cl2", "cl3", "cl4"});
            s0 = 0.03Q;
            Q f[3] = {};
            for (int i = 4; i >= 0; --i) {
                const Q term = k[5 + i] * powq(s0, i);
                f[0] += term; f[1] += i * term; f[2] += i * (i - 1) * term;
            }
            low = Cubic(f[0], f[1], f[2]);
        } else if (s.law == "lyu") {
            law = Lyu; load({"cd_low0", "cd_low1", "cd_low2", "cd_high0", "cd_high1", "cd_high2", "cl1", "cl2"});
        } else if (s.law == "usga-itr") {
            law = UsgaItr; load({"cd0", "cd1", "cd2", "cd_re", "cl0", "cl1", "cl2", "cl_re"});
            s0 = 0.042Q;
        }
        else throw std::runtime_error("unknown law " + s.law);
    }

    /// The drives of this program stay where no variable of a law is clamped ("held").
    static void within(Q x, Q lowest, Q highest, const char* what) {
        if (x < lowest || x > highest) throw std::runtime_error(std::string("held: ") + what);
    }

    void operator()(Q w, Q sr, Q re, Q v, Q& cd, Q& cl) const {
        const Q r = re / 1e5Q;
        switch (law) {
        case Robinson: cd = k[0] + k[1] * w; cl = k[2] * (1 - expq(-k[3] * w)); break;
        case Linear: cd = k[0]; cl = k[1] * sr; break;
        case SmitsSmith:
            cd = k[0] + k[1] * sr + k[2] * sinq(M_PIq * (re - k[3]) / k[4]);
            cl = below ? low(sr / s0) : k[5] * powq(sr, k[6]);
            break;
        case Ferguson:
            cd = k[0] + sr * (k[1] + sr * k[2]);
            cl = below ? low(sr / s0) : k[3] + sr * (k[4] + sr * k[5]);
            break;
        case LaunchMonitor: {
            const Q sc = k[4] * tanhq(sr / k[4]);
            cd = k[0] + sc * (k[1] + sc * k[2]) + k[3] * (re / 1e5Q - 1.5Q);
            cl = k[5] * k[6] * sr / (1 + k[6] * sr);
            break;
        }
        case MacdonaldHanzely: {
            const Q full = k[1] / v;
            cd = k[0] / v;
            cl = below ? Cubic(full, 0, 0)(sr / s0) : full;
            break;
        }
        case NaruoMizota:
            within(sr, 0, 1.13Q, "spin ratio");
            cd = cl = 0;
            for (int i = 4; i >= 0; --i) { cd = cd * sr + k[i]; cl = cl * sr + k[5 + i]; }
            if (below) cl = low(sr / s0);
            break;
        case Lyu: {
            within(sr, 0, 0.32Q, "spin ratio");
            const Q part = (1 + tanhq((r - 0.875Q) / 0.06Q)) / 2;
            cd = (1 - part) * (k[0] + r * (k[1] + r * k[2])) + part * (k[3] + r * (k[4] + r * k[5]));
            cl = sr * (k[6] + sr * k[7]);
            break;
        }
        case UsgaItr: {
            within(sr, 0, 0.3Q, "spin ratio");
            within(r, 0.6Q, 1e9Q, "Reynolds number");
            const Q base = k[4] + k[7] / (r * r), a = k[5] * s0, b = k[6] * s0 * s0;
            cd = k[0] + sr * (k[1] + sr * k[2]) + k[3] * r;
            cl = below ? Cubic(base + a + b, a + 2 * b, 2 * b)(sr / s0) : base + sr * (k[5] + sr * k[6]);
            break;
        }
        }
    }
};

// ---------------------------------------------------------------- flight
/// State: height, lateral, downrange, their rates, and ln(spin magnitude / initial spin magnitude).
using State = std::array<Q, 7>;

/// Settings of the integrator, Gragg-Bulirsch-Stoer extrapolation with `columns` columns (order
/// 2*columns). Steps are chosen so that the estimated error of one step stays below `tol` (m, m/s,
/// 1).
struct Numerics {
    int columns = 12;
    Q tol = 1e-28Q;
    Q h_max = 0.4Q;
};

struct Flight {
    const Setup& s;
    Aero aero;
    Q m, R, A, rho, mu, g, delta, kappa, ground, z0, Lref;
    V3 wref, w0;
    Q eta2 = 1e-12Q, vel2 = 1e-12Q;   // (1e-6 rad/s)^2, (1e-6 m/s)^2
    mutable Q s_min = 1e30Q, s_max = 0;  // spin ratios met at step ends

    Flight(const Setup& su, V3 omega0) : s(su), aero(su), w0(omega0) {
        m = s.num("ball.mass"); R = s.num("ball.radius"); A = M_PIq * R * R;
        rho = s.num("air.density"); mu = s.num("air.viscosity"); g = s.num("gravity");
        delta = s.num("aero.spin_decay"); kappa = s.opt("aero.spin_damping", 0);
        ground = s.num("ground.height");
        wref = {s.num("wind.up"), s.num("wind.right"), s.num("wind.downrange")};
        z0 = s.opt("wind.roughness", 0);
        if (z0 != 0) Lref = log_profile(s.opt("wind.reference_height", 10));
    }
    Q log_profile(Q z) const { return logq(1 + (z + sqrtq(z * z + 0.25Q)) / 2 / z0); }

    State rhs(const State& y) const {
        const V3 v{y[3], y[4], y[5]};
        const Q scale = z0 == 0 ? Q(1) : log_profile(y[0] - ground) / Lref;
        const V3 vr = v - scale * wref;
        const Q speed = sqrtq(dot(vr, vr) + vel2);
        const V3 w = expq(y[6]) * w0;
        const Q om = sqrtq(dot(w, w) + eta2);
        const Q sr = R * om / speed, re = rho * speed * 2 * R / mu;
        Q cd = 0, cl = 0;
        aero(om, sr, re, speed, cd, cl);
        const Q f = rho * A * speed / (2 * m);
        const V3 a = (-f * cd) * vr + (f * cl / om) * cross(w, vr);
        return {v.x, v.y, v.z, a.x - g, a.y, a.z, -(delta + kappa * speed / R)};
    }

    Q spin_ratio(const State& y) const {
        const Q scale = z0 == 0 ? Q(1) : log_profile(y[0] - ground) / Lref;
        const V3 vr = V3{y[3], y[4], y[5]} - scale * wref, w = expq(y[6]) * w0;
        return R * sqrtq(dot(w, w) + eta2) / sqrtq(dot(vr, vr) + vel2);
    }

    /// One extrapolated step of length h; `err` gets the estimated error.
    State step(const State& y, const State& f0, Q h, int columns, Q& err) const {
        std::vector<State> T(columns);
        for (int k = 0; k < columns; ++k) {
            const int n = 2 * (k + 1);  // Gragg's midpoint rule, even n: error series in (h/n)^2
            const Q d = h / n;
            State a = y, b;
            for (int i = 0; i < 7; ++i) b[i] = y[i] + d * f0[i];
            for (int j = 1; j < n; ++j) {
                const State f = rhs(b);
                for (int i = 0; i < 7; ++i) { const Q c = a[i] + 2 * d * f[i]; a[i] = b[i]; b[i] = c; }
            }
            State cur = b;  // Neville towards d = 0; T[j] holds column j of the previous row
            for (int j = 0; j < k; ++j) {
                const Q r = Q(k + 1) / Q(k - j), q = r * r - 1;
                State next;
                for (int i = 0; i < 7; ++i) next[i] = cur[i] + (cur[i] - T[j][i]) / q;
                T[j] = cur;
                cur = next;
            }
            if (k == columns - 1) {
                err = 0;
                for (int i = 0; i < 7; ++i) err = fmaxq(err, fabsq(cur[i] - T[k - 1][i]));
                return cur;
            }
            T[k] = cur;
        }
        return y;
    }

    struct Result {
        Q t, apex_t;
        State land, apex;
        int steps = 0, crossings = 0;
        bool landed = false;
        Q sum_err = 0;
    };

    /// Flies to the ground. Both events are points of the exact solution: the step that holds the event is
    /// repeated with the length at which height = ground (or climb rate = 0), found by Newton.
    Result fly(V3 v0, const Numerics& num) const {
        Result out;
        State y{0, 0, 0, v0.x, v0.y, v0.z, 0};
        out.apex = y;  // the launch point, if nothing is higher
        out.apex_t = 0;
        Q t = 0, h = 0.05Q;
        aero.below = spin_ratio(y) < aero.s0;
        s_min = s_max = spin_ratio(y);
        while (t < 60 * 10) {
            const State f0 = rhs(y);
            Q err;
            State y1 = step(y, f0, h, num.columns, err);
            const Q fac = 0.85Q * powq(num.tol / fmaxq(err, 1e-60Q), Q(1) / (2 * num.columns - 1));
            if (err > num.tol) { h *= fmaxq(fac, 0.2Q); continue; }
            // Where the spin ratio passes s0, C_L's third derivative jumps. This step ends there
            // (found by the secant method), on the branch of C_L of this side. The next step begins
            // on the other branch.
            bool crosses = aero.s0 > 0 && (spin_ratio(y1) < aero.s0) != aero.below;
            if (crosses) {
                Q xa = 0, fa = spin_ratio(y) - aero.s0, xb = h, fb = spin_ratio(y1) - aero.s0;
                for (int it = 0; it < 60 && fabsq(xb - xa) > 1e-30Q && fb != fa; ++it) {
                    Q e2;
                    const Q x = xb - fb * (xb - xa) / (fb - fa);
                    xa = xb; fa = fb;
                    xb = x;
                    y1 = step(y, f0, x, num.columns, e2);
                    fb = spin_ratio(y1) - aero.s0;
                }
                h = xb;
            }
            // Newton for the step length at which component i of the state takes `target`.
            auto locate = [&](int i, Q target, Q guess, State& at) {
                Q x = guess;
                for (int it = 0; it < 30; ++it) {
                    Q e2;
                    at = step(y, f0, x, num.columns, e2);
                    const Q rate = rhs(at)[i], dx = (at[i] - target) / rate;
                    if (it > 3 && fabsq(dx) < 1e-31Q) break;
                    x -= dx;
                    if (fabsq(dx) < 1e-18Q) {  // quadratic convergence: the next one is exact
                        at = step(y, f0, x, num.columns, e2);
                        break;
                    }
                }
                return x;
            };
            if (y[3] > 0 && y1[3] <= 0) {
                State at;
                const Q x = locate(3, 0, h * y[3] / (y[3] - y1[3]), at);
                if (at[0] > out.apex[0]) { out.apex = at; out.apex_t = t + x; }
            }
            if (y1[0] <= ground && y1[3] < 0 && (y[0] > ground || (y[0] == ground && t == 0 && y[3] > 0))) {
                // A point inside the step, by a Hermite cubic's bisection: good enough to start Newton.
                Q lo = 0, hi = 1;
                const bool rising = y[3] > 0;
                for (int it = 0; it < 40; ++it) {
                    const Q u = (lo + hi) / 2, c = 1 - u;
                    const Q x = c * c * (1 + 2 * u) * y[0] + u * u * (1 + 2 * c) * y1[0] + h * u * c * (c * y[3] - u * y1[3]);
                    (x > ground || (rising && u < 1e-3Q) ? lo : hi) = u;
                }
                const Q x = locate(0, ground, h * lo, out.land);
                out.t = t + x;
                out.landed = true;
                s_min = fminq(s_min, spin_ratio(out.land));
                s_max = fmaxq(s_max, spin_ratio(out.land));
                return out;
            }
            y = y1;
            t += h;
            s_min = fminq(s_min, spin_ratio(y));
            s_max = fmaxq(s_max, spin_ratio(y));
            out.steps++;
            out.sum_err += err;
            if (crosses) { aero.below = !aero.below; out.crossings++; }
            h = crosses ? Q(0.05Q) : fminq(h * fminq(fac, 3), num.h_max);
        }
        return out;
    }
};

// ---------------------------------------------------------------- outcomes
static const char* const SCALARS[] = {
    "carry", "lateral", "flight_time", "apex_height", "apex_time", "apex_downrange", "descent_angle", "landing_speed",
    "ball_speed", "smash_factor", "launch_angle", "launch_direction", "spin", "backspin", "sidespin", "spin_axis"};
constexpr int N_SCALARS = 16;
enum { CARRY, LATERAL, FLIGHT_TIME, APEX_HEIGHT, APEX_TIME, APEX_DOWNRANGE, DESCENT, LANDING_SPEED, BALL_SPEED, SMASH,
       LAUNCH_ANGLE, LAUNCH_DIRECTION, SPIN, BACKSPIN, SIDESPIN, SPIN_AXIS };

struct Drive {
    std::array<Q, N_SCALARS> x;
    Impact hit;
    Q s_min, s_max, s0, sum_err;
    int steps, crossings;
};

inline Drive drive(const Setup& s, const Numerics& num = {}) {
    Drive o;
    o.hit = impact(s);
    const V3 v = o.hit.v, w = o.hit.w;
    o.x[BALL_SPEED] = norm(v);
    o.x[SMASH] = o.x[BALL_SPEED] / s.num("swing.speed");
    const Q horizontal = sqrtq(v.y * v.y + v.z * v.z);
    const Q la = o.x[LAUNCH_ANGLE] = atan2q(v.x, horizontal), ld = o.x[LAUNCH_DIRECTION] = atan2q(v.y, v.z);
    o.x[SPIN] = dot(w, w) / sqrtq(dot(w, w) + 1e-12Q);
    // Axes across the launch direction: level, to the right; and upward in its vertical plane. Spin about the
    // second curves the ball left, hence the minus.
    o.x[BACKSPIN] = dot(w, {0, cosq(ld), -sinq(ld)});
    o.x[SIDESPIN] = -dot(w, {cosq(la), -sinq(la) * sinq(ld), -sinq(la) * cosq(ld)});
    o.x[SPIN_AXIS] = atan2q(o.x[SIDESPIN], o.x[BACKSPIN]);

    const Flight flight(s, w);
    const auto r = flight.fly(v, num);
    if (!r.landed) throw std::runtime_error("the ball did not land");
    o.x[CARRY] = r.land[2];
    o.x[LATERAL] = r.land[1];
    o.x[FLIGHT_TIME] = r.t;
    o.x[APEX_HEIGHT] = r.apex[0];
    o.x[APEX_TIME] = r.apex_t;
    o.x[APEX_DOWNRANGE] = r.apex[2];
    o.x[DESCENT] = atan2q(-r.land[3], sqrtq(r.land[4] * r.land[4] + r.land[5] * r.land[5]));
    o.x[LANDING_SPEED] = norm({r.land[3], r.land[4], r.land[5]});
    o.s_min = flight.s_min; o.s_max = flight.s_max; o.s0 = flight.aero.s0;
    o.sum_err = r.sum_err; o.steps = r.steps; o.crossings = r.crossings;
    return o;
}
