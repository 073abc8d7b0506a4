// Multi-start damped Newton for the inverse kinematics of any serial chain, several starts in lanes; for long hunts.
//
// It knows nothing of the library: a chain is constant matrices and rotations about, or slides along, the z axis.
// Build: g++ -O3 -march=native -ffast-math -shared -fPIC starts.cpp -o starts.so   (oracle/starts.py does it)
#include <cmath>
#include <cstdint>

namespace {

// one register's worth of lanes: twice as many run four times slower, because nothing stays in registers
#ifdef __AVX512F__
constexpr int W = 8, MAXN = 8;
#else
constexpr int W = 4, MAXN = 8;
#endif
typedef double vec __attribute__((vector_size(8 * W)));

vec splat(double x) { return x - vec{}; }

void sincos(vec x, vec& s, vec& c) {
  vec k;
  for (int l = 0; l < W; ++l) k[l] = __builtin_rint(x[l] * (2 / M_PI));
  vec r = (x - k * 1.5707963267948966) - k * 6.123233995736766e-17;
  vec r2 = r * r;
  vec sr =
      r *
      (1 + r2 * (-1.0 / 6 +
                 r2 * (1.0 / 120 +
                       r2 * (-1.0 / 5040 + r2 * (1.0 / 362880 + r2 * (-1.0 / 39916800 + r2 * (1.0 / 6227020800.0)))))));
  vec cr =
      1 + r2 * (-0.5 + r2 * (1.0 / 24 + r2 * (-1.0 / 720 +
                                              r2 * (1.0 / 40320 + r2 * (-1.0 / 3628800 + r2 * (1.0 / 479001600.0 -
                                                                                               r2 / 87178291200.0))))));
  for (int l = 0; l < W; ++l) {
    int quadrant = int(long(k[l]) & 3);
    double a = sr[l], b = cr[l];
    s[l] = quadrant == 0 ? a : quadrant == 1 ? b : quadrant == 2 ? -a : -b;
    c[l] = quadrant == 0 ? b : quadrant == 1 ? -a : quadrant == 2 ? -b : a;
  }
}

struct Chain {
  int n;
  const double* links;    // (n + 1) x 16
  const uint8_t* slides;  // n
};

struct Model {  // cost, gradient and Gauss-Newton matrix at one q
  vec cost, g[MAXN], H[MAXN][MAXN];
};

// task: 0 pose, 1 position, 2 position and z axis
void evaluate(const Chain& ch, const double* T, int task, const vec* q, Model& m) {
  vec R[3][3], p[3], z[MAXN][3], o[MAXN][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) R[i][j] = splat(ch.links[4 * i + j]);
    p[i] = splat(ch.links[4 * i + 3]);
  }
  for (int k = 0; k < ch.n; ++k) {
    for (int i = 0; i < 3; ++i) z[k][i] = R[i][2], o[k][i] = p[i];
    if (ch.slides[k]) {
      for (int i = 0; i < 3; ++i) p[i] += R[i][2] * q[k];
    } else {
      vec s, c;
      sincos(q[k], s, c);
      for (int i = 0; i < 3; ++i) {
        vec x = R[i][0] * c + R[i][1] * s, y = R[i][1] * c - R[i][0] * s;
        R[i][0] = x, R[i][1] = y;
      }
    }
    const double* L = ch.links + 16 * (k + 1);
    for (int i = 0; i < 3; ++i) {
      vec a = R[i][0], b = R[i][1], c = R[i][2];
      p[i] += a * L[3] + b * L[7] + c * L[11];
      for (int j = 0; j < 3; ++j) R[i][j] = a * L[j] + b * L[4 + j] + c * L[8 + j];
    }
  }
  vec e[3], w[3] = {splat(0), splat(0), splat(0)};
  m.cost = splat(0);
  for (int i = 0; i < 3; ++i) e[i] = T[4 * i + 3] - p[i], m.cost += e[i] * e[i];
  for (int c = task == 0 ? 0 : 2; task != 1 && c < 3; ++c)
    for (int i = 0; i < 3; ++i) {
      int j = (i + 1) % 3, k = (i + 2) % 3;
      vec d = R[i][c] - T[4 * i + c];
      m.cost += d * d;
      w[i] += R[j][c] * T[4 * k + c] - R[k][c] * T[4 * j + c];
    }
  vec v[MAXN][3], zr[MAXN];
  for (int k = 0; k < ch.n; ++k) {
    if (ch.slides[k]) {
      for (int i = 0; i < 3; ++i) v[k][i] = z[k][i];
    } else {
      for (int i = 0; i < 3; ++i) {
        int a = (i + 1) % 3, b = (i + 2) % 3;
        v[k][i] = z[k][a] * (p[b] - o[k][b]) - z[k][b] * (p[a] - o[k][a]);
      }
    }
    zr[k] = z[k][0] * R[0][2] + z[k][1] * R[1][2] + z[k][2] * R[2][2];
    m.g[k] = v[k][0] * e[0] + v[k][1] * e[1] + v[k][2] * e[2];
    if (!ch.slides[k] && task != 1) m.g[k] += z[k][0] * w[0] + z[k][1] * w[1] + z[k][2] * w[2];
    for (int l = 0; l <= k; ++l) {
      m.H[k][l] = v[k][0] * v[l][0] + v[k][1] * v[l][1] + v[k][2] * v[l][2];
      if (ch.slides[k] || ch.slides[l] || task == 1) continue;
      vec dot = z[k][0] * z[l][0] + z[k][1] * z[l][1] + z[k][2] * z[l][2];
      m.H[k][l] += task == 0 ? 2 * dot : dot - zr[k] * zr[l];
    }
  }
}

void step(int n, const Model& m, const vec& damping, vec* d) {
  vec L[MAXN][MAXN], y[MAXN];
  for (int k = 0; k < n; ++k)
    for (int l = 0; l <= k; ++l) {
      vec s = m.H[k][l];
      if (k == l) s += damping;
      for (int j = 0; j < l; ++j) s -= L[k][j] * L[l][j];
      if (k == l) {
        for (int w = 0; w < W; ++w) L[k][k][w] = std::sqrt(s[w] > 1e-30 ? s[w] : 1e-30);
      } else {
        L[k][l] = s / L[l][l];
      }
    }
  for (int k = 0; k < n; ++k) {
    vec s = m.g[k];
    for (int j = 0; j < k; ++j) s -= L[k][j] * y[j];
    y[k] = s / L[k][k];
  }
  for (int k = n - 1; k >= 0; --k) {
    vec s = y[k];
    for (int j = k + 1; j < n; ++j) s -= L[j][k] * d[j];
    d[k] = s / L[k][k];
  }
  vec big = splat(0);
  for (int k = 0; k < n; ++k) big += d[k] * d[k];
  for (int w = 0; w < W; ++w) {
    double f = big[w] > 1.0 ? 1 / std::sqrt(big[w]) : 1.0;
    for (int k = 0; k < n; ++k) d[k][w] *= f;
  }
}

// A start is given up in a local minimum: a cost far from nothing whose gradient is next to nothing.
bool stuck(int n, const Model& m, int w) {
  if (m.cost[w] < 1e-8) return false;
  double g = 0;
  for (int k = 0; k < n; ++k) g += m.g[k][w] * m.g[k][w];
  return g < 1e-8 * m.cost[w] * m.cost[w];
}

}  // namespace

// starts (count, n); out (count, n) receives those whose cost fell below `enough`, or below 1e-20 and then no further.
// Returns how many.
extern "C" int search(int n, const double* links, const uint8_t* slides, const double* T, int task,
                      const double* starts, int count, int iterations, double enough, double* out) {
  Chain ch{n, links, slides};
  vec q[MAXN], damping, trial[MAXN], d[MAXN];
  Model here, there;
  int left[W], next = 0, found = 0;
  bool busy[W], refused[W];
  for (int w = 0; w < W; ++w) busy[w] = refused[w] = false, left[w] = 0;
  for (int k = 0; k < n; ++k) q[k] = splat(0);
  damping = splat(1e-2);
  evaluate(ch, T, task, q, here);
  for (;;) {
    bool fresh = false, any = false;
    for (int w = 0; w < W; ++w) {
      bool there_yet = here.cost[w] < enough || (here.cost[w] < 1e-20 && (refused[w] || left[w] <= 1));
      if (busy[w] && there_yet) {
        for (int k = 0; k < n; ++k) out[found * n + k] = q[k][w];
        ++found;
        busy[w] = false;
      }
      if (busy[w] && (--left[w] <= 0 || stuck(n, here, w))) busy[w] = false;
      if (!busy[w] && next < count) {
        for (int k = 0; k < n; ++k) q[k][w] = starts[next * n + k];
        ++next;
        busy[w] = fresh = true, refused[w] = false;
        damping[w] = 1e-2;
        left[w] = iterations;
      }
      any |= busy[w];
    }
    if (!any) return found;
    if (fresh) evaluate(ch, T, task, q, here);
    step(n, here, damping, d);
    for (int k = 0; k < n; ++k) trial[k] = q[k] + d[k];
    evaluate(ch, T, task, trial, there);
    for (int w = 0; w < W; ++w) {
      refused[w] = !(there.cost[w] < here.cost[w]);
      if (!refused[w]) {
        here.cost[w] = there.cost[w];
        for (int k = 0; k < n; ++k) {
          q[k][w] = trial[k][w];
          here.g[k][w] = there.g[k][w];
          for (int l = 0; l <= k; ++l) here.H[k][l][w] = there.H[k][l][w];
        }
        damping[w] = damping[w] * 0.15 > 1e-13 ? damping[w] * 0.15 : 1e-13;
      } else {
        damping[w] *= 5;
      }
    }
  }
}
