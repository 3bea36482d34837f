/* The inner loops of a search's step: rows of wrenches on links, and sums of squares in a banded matrix.
 * figure/wrenches.py and search/quadratic.py have the same in NumPy, with the reasons. Arrays are contiguous, of
 * doubles or of 64-bit integers; sizes and indices are checked before they are used. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__)
#define WIDE __attribute__((target_clones("arch=haswell", "default"))) /* also for processors with AVX2 */
#else
#define WIDE
#endif
typedef double D;
typedef int64_t I;
/* What a link's joint is: columns of the state, and places among the joints of its kind; -1 where there is none. */
enum { PARENT, POSITION, SLIDE, SLIDE_COLUMN, HINGE, HINGE_COLUMN, QUATERNION, QUATERNION_COLUMN, RELATIVE, FACTS };
enum { X, X_D, ANCHOR, ANCHOR_D, OMEGA, ALPHA, SLIDES, HINGES, WAYS, BASES, MOTIONS };
enum { VECTORS = 5, LOCAL = 4 }; /* of a wrench; coefficients that a sample sees */
typedef struct {
    I links, samples, width, orders, slides, hinges, quaternions, relatives;
    const I *facts, *after;
    const D *motion[MOTIONS];
} Figure;

static int is_within(I value, I first, I end) { return value >= first && value < end; }
static I integers(const Py_buffer *b) { return b->len / (I)sizeof(I); }
static int has(const Py_buffer *b, I doubles) { return b->len == doubles * (I)sizeof(D); }
static int all_within(const Py_buffer *b, I first, I end) {
    for (I i = 0; i < integers(b); i++)
        if (!is_within(((I *)b->buf)[i], first, end)) return 0;
    return 1;
}
static PyObject *ended(Py_buffer *b, size_t count, const char *wrong) {
    while (count--) PyBuffer_Release(b + count);
    if (wrong) return PyErr_Format(PyExc_ValueError, "the kernel's arguments do not fit: %s", wrong);
    Py_RETURN_NONE;
}
static void cross(const D *a, const D *b, D *out) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}
static void add_cross(const D *a, const D *b, D *out) {
    D c[3];
    cross(a, b, c);
    for (int i = 0; i < 3; i++) out[i] += c[i];
}
static D dot(const D *a, const D *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* entry (:, k, s) of an array (parts, n, samples) */
static void at_sample(const D *array, int parts, I n, I samples, I k, I s, D *out) {
    for (int i = 0; i < parts; i++) out[i] = array[(i * n + k) * samples + s];
}
/* the same of a vector of a link */
static void of_link(const Figure *f, int which, I link, I s, D *out) {
    at_sample(f->motion[which], 3, f->links, f->samples, link, s, out);
}

/* M0, M1, M2 in axes that turn with a link: what counts on their coordinate and its derivatives */
static void on_axes(const Figure *f, I link, I s, D m[3][3]) {
    D omega[3], alpha[3], through[3];
    of_link(f, OMEGA, link, s, omega);
    of_link(f, ALPHA, link, s, alpha);
    cross(m[2], omega, through);
    add_cross(m[1], omega, m[0]);
    add_cross(m[2], alpha, m[0]);
    add_cross(through, omega, m[0]);
    for (int i = 0; i < 3; i++) m[1][i] += 2 * through[i];
}

/* adds (0, v) (x) q of the moments v and the quaternions q that make turns of a change of a quaternion */
static void add_quaternion(const Figure *f, I place, I s, D m[3][3], D *out) {
    static const D factor[3][3] = {{1}, {1, 1}, {1, 2, 1}};
    const I n = f->quaternions, samples = f->samples;
    for (int order = 0; order < f->orders; order++)
        for (int k = 0; k <= order; k++) {
            D q[4], c[3], *to = out + (order - k) * f->width;
            at_sample(f->motion[WAYS] + k * 4 * n * samples, 4, n, samples, place, s, q);
            cross(m[order], q + 1, c);
            to[0] -= factor[order][k] * dot(m[order], q + 1);
            for (int i = 0; i < 3; i++) to[1 + i] += factor[order][k] * (m[order][i] * q[0] + c[i]);
        }
}
/* adds what counts on an axis, for every order */
static void add_axis(const Figure *f, int which, I n, I place, I s, D m[3][3], D *out) {
    D axis[3];
    at_sample(f->motion[which], 3, n, f->samples, place, s, axis);
    for (int order = 0; order < f->orders; order++) out[order * f->width] += dot(axis, m[order]);
}

/* M0, M1, M2 about a joint's anchor; next: the link whose anchor stands for the wrench's place, or 0 */
static void moments(const Figure *f, I link, I joint, I next, I s, D force[3][3], D torque[3][3], D m[3][3]) {
    D end[3], end_d[3], anchor[3], anchor_d[3];
    of_link(f, next ? ANCHOR : X, next ? next : link, s, end);
    of_link(f, next ? ANCHOR_D : X_D, next ? next : link, s, end_d);
    of_link(f, ANCHOR, joint, s, anchor);
    of_link(f, ANCHOR_D, joint, s, anchor_d);
    for (int i = 0; i < 3; i++) {
        end[i] -= anchor[i], end_d[i] -= anchor_d[i];
        for (int order = 0; order < 3; order++) m[order][i] = next ? 0 : torque[order][i];
    }
    add_cross(end, force[0], m[0]);
    add_cross(end_d, force[1], m[0]);
    add_cross(end, force[1], m[1]);
}

/* one wrench's rows (orders, width): forces and torques on place and turn, and on their derivatives */
static void one_row(const Figure *f, I link, I s, D force[3][3], D torque[3][3], D *out) {
    for (I k = link; k > 0; k = f->facts[k * FACTS + PARENT]) {
        const I *fact = f->facts + k * FACTS;
        D m[3][3], base[9];
        for (int order = 0; fact[POSITION] >= 0 && order < f->orders; order++)
            for (int i = 0; i < 3; i++) out[order * f->width + fact[POSITION] + i] += force[order][i];
        if (fact[SLIDE] >= 0) {
            memcpy(m, force, sizeof m);
            on_axes(f, k, s, m);
            add_axis(f, SLIDES, f->slides, fact[SLIDE], s, m, out + fact[SLIDE_COLUMN]);
        }
        if (fact[HINGE] >= 0) {
            moments(f, link, k, 0, s, force, torque, m);
            on_axes(f, k, s, m);
            add_axis(f, HINGES, f->hinges, fact[HINGE], s, m, out + fact[HINGE_COLUMN]);
        }
        if (fact[QUATERNION] < 0) continue;
        moments(f, link, k, fact[RELATIVE] < 0 ? f->after[link * f->links + k] : 0, s, force, torque, m);
        if (fact[RELATIVE] >= 0) {
            on_axes(f, fact[PARENT], s, m);
            at_sample(f->motion[BASES], 9, f->relatives, f->samples, fact[RELATIVE], s, base);
            for (int order = 0; order < 3; order++) {
                const D x = m[order][0], y = m[order][1], z = m[order][2];
                for (int i = 0; i < 3; i++) m[order][i] = base[i] * x + base[3 + i] * y + base[6 + i] * z;
            }
        }
        add_quaternion(f, fact[QUATERNION], s, m, out + fact[QUATERNION_COLUMN]);
    }
}
/* whether a figure's tables lead nowhere outside its arrays */
static int is_sound(const Figure *f) {
    for (I k = 0; k < f->links; k++) {
        const I *fact = f->facts + k * FACTS;
        if (!is_within(fact[PARENT], 0, k ? k : 1) || fact[POSITION] < -1 ||
            !is_within(fact[SLIDE], -1, f->slides) || !is_within(fact[HINGE], -1, f->hinges) ||
            !is_within(fact[QUATERNION], -1, f->quaternions) || !is_within(fact[RELATIVE], -1, f->relatives) ||
            (fact[POSITION] >= 0 && fact[POSITION] > f->width - 3) ||
            (fact[SLIDE] >= 0 && !is_within(fact[SLIDE_COLUMN], 0, f->width)) ||
            (fact[HINGE] >= 0 && !is_within(fact[HINGE_COLUMN], 0, f->width)) ||
            (fact[QUATERNION] >= 0 && !is_within(fact[QUATERNION_COLUMN], 0, f->width - 3)))
            return 0;
    }
    return 1;
}

/* wrench_rows(out, at, link, 5 vectors (3, P) or None, facts, after, 10 motions, samples, width, orders) */
static PyObject *wrench_rows(PyObject *self, PyObject *args) {
    Py_buffer b[5 + VECTORS + MOTIONS], *v = b + 3, *tables = v + VECTORS, *m = tables + 2;
    long long S, N, orders;
    if (!PyArg_ParseTuple(args, "w*y*y*z*z*z*z*z*y*y*y*y*y*y*y*y*y*y*y*y*LLL", b, b + 1, b + 2, v, v + 1, v + 2, v + 3,
                          v + 4, tables, tables + 1, m, m + 1, m + 2, m + 3, m + 4, m + 5, m + 6, m + 7, m + 8, m + 9,
                          &S, &N, &orders))
        return NULL;
    const I P = integers(b + 1), L = integers(tables) / FACTS, line = 8 * S, *at = b[1].buf, *link = b[2].buf;
    int fits = S > 0 && N > 0 && is_within(orders, 1, 4) && has(b, P * orders * N) && integers(b + 2) == P;
    fits = fits && all_within(b + 1, 0, S) && all_within(b + 2, 0, L);
    fits = fits && integers(tables) == L * FACTS && integers(tables + 1) == L * L && all_within(tables + 1, 0, L);
    for (int i = 0; i < VECTORS; i++) fits = fits && (!v[i].buf || has(v + i, 3 * P));
    for (int i = 0; i < SLIDES; i++) fits = fits && has(m + i, 3 * L * S);
    if (!fits) return ended(b, sizeof b / sizeof *b, "sizes, samples or links");
    Figure f = {L, S, N, orders, m[SLIDES].len / (3 * line), m[HINGES].len / (3 * line), m[WAYS].len / (12 * line),
                m[BASES].len / (9 * line), tables[0].buf, tables[1].buf, {0}};
    for (int i = 0; i < MOTIONS; i++) f.motion[i] = m[i].buf;
    if (!is_sound(&f)) return ended(b, sizeof b / sizeof *b, "the figure's tables");
    Py_BEGIN_ALLOW_THREADS
    memset(b[0].buf, 0, (size_t)b[0].len);
    for (I p = 0; p < P; p++) {
        D force[3][3] = {{0}}, torque[3][3] = {{0}}, omega[3], alpha[3];
        D *to[VECTORS] = {force[0], torque[0], force[1], torque[1], torque[2]};
        for (int k = 0; k < VECTORS; k++)
            for (int i = 0; v[k].buf && i < 3; i++) to[k][i] = ((const D *)v[k].buf)[i * P + p];
        of_link(&f, OMEGA, link[p], at[p], omega);
        of_link(&f, ALPHA, link[p], at[p], alpha);
        add_cross(omega, torque[1], torque[0]);
        add_cross(alpha, torque[2], torque[0]);
        add_cross(omega, torque[2], torque[1]);
        one_row(&f, link[p], at[p], force, torque, (D *)b[0].buf + p * orders * N);
    }
    Py_END_ALLOW_THREADS
    return ended(b, sizeof b / sizeof *b, NULL);
}

/* how many blocks a matrix (M, N, blocks, N) has; 0 if the rank (M,) of its coefficients, the first (S,) of the 4 that
 * each sample sees or their bases (S, orders, 4) do not fit it */
static I blocks_of(const Py_buffer *b, I N, I orders) {
    const I M = integers(b + 1), *rank = b[1].buf, *first = b[2].buf;
    const I blocks = M && N > 0 ? b->len / (M * N * N * 8) : 0;
    if (N < 1 || !has(b, M * N * N * blocks) || !has(b + 3, orders * LOCAL * integers(b + 2))) return 0;
    if (!all_within(b + 1, 0, M) || !all_within(b + 2, 0, M - LOCAL + 1)) return 0;
    for (I s = 0; s < integers(b + 2); s++)
        for (int a = 0; a < LOCAL * LOCAL; a++)
            if (rank[first[s] + a / LOCAL] - rank[first[s] + a % LOCAL] >= blocks) return 0;
    return blocks;
}

/* the squares of n rows of one sample, each times its weight: its T columns that are not all zero, and in `square` the
 * lines (T, N) of the matrix there */
WIDE static I squared(const D *rows, const D *weight, I n, I N, D *square, I *columns) {
    I T = 0;
    for (I c = 0, p; c < N; c++) {
        for (p = 0; p < n && (weight[p] == 0 || rows[p * N + c] == 0); p++) {}
        if (p < n) columns[T++] = c;
    }
    memset(square, 0, (size_t)(T * N) * sizeof(D));
    for (I p = 0; p < n; p++)
        for (I j = 0; j < T; j++) {
            const D factor = weight[p] * rows[p * N + columns[j]];
            if (factor != 0)
                for (I c = 0; c < N; c++) square[j * N + c] += factor * rows[p * N + c];
        }
    return T;
}

/* adds phi_a phi_b times lines (T, N) of a matrix to the blocks of a sample's coefficients */
WIDE static void spread(D *room, I N, I blocks, const I *rank, const D *phi, const D *square, const I *columns, I T) {
    for (int ab = 0; ab < LOCAL * LOCAL; ab++) {
        const int a = ab / LOCAL, b = ab % LOCAL;
        const D share = phi[a] * phi[b];
        for (I j = 0; rank[a] >= rank[b] && share != 0 && j < T; j++) {
            D *line = room + ((rank[b] * N + columns[j]) * blocks + rank[a] - rank[b]) * N;
            for (I r = 0; r < N; r++) line[r] += share * square[j * N + r];
        }
    }
}

/* add_squares(room (M, N, blocks, N), rank (M,), first (S,), phi (S, 4), at (P,) rising, rows (P, N), weight (P,)) */
static PyObject *add_squares(PyObject *self, PyObject *args) {
    Py_buffer b[7];
    if (!PyArg_ParseTuple(args, "w*y*y*y*y*y*y*", b, b + 1, b + 2, b + 3, b + 4, b + 5, b + 6)) return NULL;
    const I P = integers(b + 4), N = P ? b[5].len / (P * 8) : 0, blocks = P ? blocks_of(b, N, 1) : 0;
    const I *rank = b[1].buf, *first = b[2].buf, *at = b[4].buf;
    const D *phi = b[3].buf, *rows = b[5].buf, *weight = b[6].buf;
    int fits = !P || (blocks && has(b + 5, P * N) && has(b + 6, P) && all_within(b + 4, 0, integers(b + 2)));
    for (I p = 1; fits && p < P; p++) fits = at[p] >= at[p - 1];
    if (!P || !fits) return ended(b, 7, fits ? NULL : "rows and matrix");
    D *square = malloc((size_t)(N * N) * sizeof(D));
    I *columns = malloc((size_t)N * sizeof(I));
    Py_BEGIN_ALLOW_THREADS
    for (I begin = 0, end; square && columns && begin < P; begin = end) {
        const I s = at[begin];
        for (end = begin; end < P && at[end] == s; end++) {}
        const I T = squared(rows + begin * N, weight + begin, end - begin, N, square, columns);
        spread(b[0].buf, N, blocks, rank + first[s], phi + LOCAL * s, square, columns, T);
    }
    Py_END_ALLOW_THREADS
    const char *wrong = square && columns ? NULL : "too little memory";
    free(square), free(columns);
    return ended(b, 7, wrong);
}

/* adds the matrix (3, k, 3, k) of some columns at one sample, phi (3, 4), to the blocks of its coefficients */
static void add_block(D *room, I N, I blocks, const I *rank, const D *phi, const D *matrix, const I *columns, I k) {
    for (int b = 0; b < LOCAL; b++)
        for (I j = 0; j < k; j++)
            for (I i = 0; i < k; i++) {
                D half[3]; /* by order of row i */
                for (int o = 0; o < 3; o++) {
                    const D *line = matrix + (o * k + i) * 3 * k + j;
                    half[o] = phi[b] * line[0] + phi[LOCAL + b] * line[k] + phi[2 * LOCAL + b] * line[2 * k];
                }
                D *entry = room + (rank[b] * N + columns[j]) * blocks * N + columns[i];
                for (const D *p = phi; p < phi + LOCAL; p++) {
                    const I apart = rank[p - phi] - rank[b];
                    if (apart >= 0) entry[apart * N] += p[0] * half[0] + p[LOCAL] * half[1] + p[2 * LOCAL] * half[2];
                }
            }
}

/* add_blocks(room, rank, first as above, phi (S, 3, 4), columns (n, k), matrices (S, n, 3, k, 3, k), N) */
static PyObject *add_blocks(PyObject *self, PyObject *args) {
    Py_buffer b[6];
    long long N;
    if (!PyArg_ParseTuple(args, "w*y*y*y*y*y*L", b, b + 1, b + 2, b + 3, b + 4, b + 5, &N)) return NULL;
    const I S = integers(b + 2), all = integers(b + 4), k = S && all ? b[5].len / (9 * S * all * 8) : 0;
    const I *rank = b[1].buf, *first = b[2].buf, blocks = blocks_of(b, N, 3);
    int fits = !S || !all || (blocks && k && all % k == 0 && has(b + 5, 9 * S * all * k));
    fits = fits && all_within(b + 4, 0, N);
    Py_BEGIN_ALLOW_THREADS
    for (I s = 0; fits && k && s < S; s++)
        for (I q = 0; q < all; q += k)
            add_block(b[0].buf, N, blocks, rank + first[s], (D *)b[3].buf + 3 * LOCAL * s,
                      (D *)b[5].buf + 9 * k * (s * all + q), (I *)b[4].buf + q, k);
    Py_END_ALLOW_THREADS
    return ended(b, 6, fits ? NULL : "blocks and matrix");
}

static PyMethodDef methods[] = {{"wrench_rows", wrench_rows, METH_VARARGS, "Rows of wrenches on links."},
                                {"add_squares", add_squares, METH_VARARGS, "Adds squares of rows to a banded matrix."},
                                {"add_blocks", add_blocks, METH_VARARGS, "Adds blocks of columns to a banded matrix."},
                                {NULL, NULL, 0, NULL}};
static struct PyModuleDef module = {PyModuleDef_HEAD_INIT, .m_name = "kernel", .m_size = -1, .m_methods = methods};
PyMODINIT_FUNC PyInit_kernel(void) { return PyModule_Create(&module); }
