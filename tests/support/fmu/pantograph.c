/* A pantograph as an FMU for co-simulation, FMI 2.0 (default) or 3.0 (-DFMI=3), for tests.

   Two masses in a chain and STRIPS strips on the second, the pantograph `ac-simple` of the library
   (with one strip: 6, 9 and 7.5 kg). Displacements u count from the start, where the springs hold
   it in balance with static_force F0 shared by the strips:

     m1 a1 = -k1 (u1 - b) - c1 (v1 - vb) + k2 (u2 - u1) + c2 (v2 - v1) + control_force + lift v^2
     m2 a2 = -k2 (u2 - u1) - c2 (v2 - v1) + sum k3 (s - u2) + c3 (s' - v2)
     m3 s'' = -k3 (s - u2) - c3 (s' - v2) - K e^3 + F0/STRIPS - contact force,   e = s - u2

   scheme 0: Runge-Kutta of order 4 in eight parts of a step, which is exact to 1e-11; 1: the
   trapezoidal rule, with inputs held over the step.

   Faults, from a time on: -DCRASH=t (segmentation fault), -DEXIT=t, -DHANG=t, -DNOTANUMBER=t,
   -DFAIL=t (status error), -DSPEAK (prints to standard output at each step). -DNOSTATE: a state
   cannot be saved. -DLIFTS: the contact force pushes up. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef FMI
#define FMI 2
#endif
#ifndef STRIPS
#define STRIPS 1
#endif
#define N (2 + STRIPS)
#define PARTS 8

typedef struct {
    double u[N], v[N];
    double contact[STRIPS];
    double static_force, start_height, base, base_velocity, speed, position, control;
    double scheme, hardening, time;
} Model;

static const double M[2] = {6.0, 9.0}, K[2] = {160.0, 15500.0}, C[2] = {100.0, 0.1};
static const double M3 = 7.5 / STRIPS, K3 = 7000.0 / STRIPS, C3 = 45.0 / STRIPS;
#ifdef LIFTS
#define SIGN 1.0
#else
#define SIGN -1.0
#endif

static double *at(Model *m, unsigned reference) {
    if (reference >= 10 && reference < 10 + STRIPS) return &m->contact[reference - 10];
    switch (reference) {
    case 1: return &m->static_force;
    case 2: return &m->start_height;
    case 3: return &m->base;
    case 4: return &m->base_velocity;
    case 5: return &m->speed;
    case 6: return &m->position;
    case 7: return &m->control;
    case 8: return &m->scheme;
    case 9: return &m->hardening;
    default: return NULL;
    }
}

static void accelerations(const Model *m, const double *u, const double *v, double *a) {
    double below = -K[0] * (u[0] - m->base) - C[0] * (v[0] - m->base_velocity);
    double between = K[1] * (u[1] - u[0]) + C[1] * (v[1] - v[0]);
    double on_second = -between;
    for (int i = 0; i < STRIPS; i++) {
        double e = u[2 + i] - u[1];
        double pull = K3 * e + C3 * (v[2 + i] - v[1]) + m->hardening * e * e * e;
        on_second += pull;
        a[2 + i] = (-pull + m->static_force / STRIPS + SIGN * m->contact[i]) / M3;
    }
    a[0] = (below + between + m->control) / M[0];
    a[1] = on_second / M[1];
}

static void runge_kutta(Model *m, double h) {
    double u[N], v[N], k[4][N], l[4][N];
    for (int s = 0; s < 4; s++) {
        double c = s == 0 ? 0.0 : s == 3 ? h : h / 2.0;
        for (int i = 0; i < N; i++) {
            u[i] = m->u[i] + (s ? c * k[s - 1][i] : 0.0);
            v[i] = m->v[i] + (s ? c * l[s - 1][i] : 0.0);
        }
        accelerations(m, u, v, l[s]);
        memcpy(k[s], v, sizeof v);
    }
    for (int i = 0; i < N; i++) {
        m->u[i] += h / 6.0 * (k[0][i] + 2.0 * k[1][i] + 2.0 * k[2][i] + k[3][i]);
        m->v[i] += h / 6.0 * (l[0][i] + 2.0 * l[1][i] + 2.0 * l[2][i] + l[3][i]);
    }
}

/* Newton's method with differences on v' = v + h a((u + u')/2, (v + v')/2), u' = u + h (v + v')/2:
   one iteration of the linear model is exact, and a second one takes its rounding away. */
static void trapezoidal(Model *m, double h) {
    double w[N];
    memcpy(w, m->v, sizeof w);
    for (int round = 0; round < 4; round++) {
        double r[N], j[N][N + 1];
        for (int c = -1; c < N; c++) {
            double u[N], v[N], a[N], t[N];
            memcpy(t, w, sizeof t);
            if (c >= 0) t[c] += 1.0;
            for (int i = 0; i < N; i++) {
                v[i] = (m->v[i] + t[i]) / 2.0;
                u[i] = m->u[i] + h / 2.0 * v[i];
            }
            accelerations(m, u, v, a);
            for (int i = 0; i < N; i++) {
                double f = t[i] - m->v[i] - h * a[i];
                if (c < 0) r[i] = f; else j[i][c] = f - r[i];
            }
        }
        for (int i = 0; i < N; i++) j[i][N] = -r[i];
        for (int p = 0; p < N; p++)
            for (int i = 0; i < N; i++)
                if (i != p) {
                    double q = j[i][p] / j[p][p];
                    for (int c = p; c <= N; c++) j[i][c] -= q * j[p][c];
                }
        for (int i = 0; i < N; i++) w[i] += j[i][N] / j[i][i];
    }
    for (int i = 0; i < N; i++) {
        m->u[i] += h / 2.0 * (m->v[i] + w[i]);
        m->v[i] = w[i];
    }
}

static Model *made(void) { return calloc(1, sizeof(Model)); }

static int set(Model *m, const unsigned *references, size_t count, const double *values) {
    for (size_t i = 0; i < count; i++) {
        double *place = at(m, references[i]);
        if (!place) return 3;
        *place = values[i];
    }
    return 0;
}

static int get(Model *m, const unsigned *references, size_t count, double *values) {
    for (size_t i = 0; i < count; i++) {
        unsigned r = references[i];
        double *place = at(m, r);
        if (r >= 20 && r < 20 + STRIPS) values[i] = m->start_height + m->u[2 + r - 20];
        else if (place) values[i] = *place;
        else return 3;
#ifdef NOTANUMBER
        if (m->time > NOTANUMBER) values[i] = NAN;
#endif
    }
    return 0;
}

static int step(Model *m, double h) {
#ifdef SPEAK
    printf("step at %g\n", m->time);
    fflush(stdout);
#endif
#ifdef CRASH
    if (m->time > CRASH) *(volatile int *)8 = 1;
#endif
#ifdef EXIT
    if (m->time > EXIT) { fprintf(stderr, "licence not found\n"); exit(7); }
#endif
#ifdef HANG
    while (m->time > HANG) ;
#endif
#ifdef FAIL
    if (m->time > FAIL) return 3;
#endif
    if (m->scheme > 0.5) trapezoidal(m, h);
    else for (int i = 0; i < PARTS; i++) runge_kutta(m, h / PARTS);
    m->time += h;
    return 0;
}

static int save(Model *m, void **state) {
#ifdef NOSTATE
    return 3;
#endif
    if (!*state) *state = malloc(sizeof(Model));
    memcpy(*state, m, sizeof(Model));
    return 0;
}

static int restore(Model *m, void *state) {
#ifdef NOSTATE
    return 3;
#endif
    memcpy(m, state, sizeof(Model));
    return 0;
}

static int forget(void **state) { free(*state); *state = NULL; return 0; }
static int size_of(size_t *size) { *size = sizeof(Model); return 0; }
static int write_to(void *state, void *bytes, size_t size) {
    if (size < sizeof(Model)) return 3;
    memcpy(bytes, state, sizeof(Model));
    return 0;
}
static int read_from(const void *bytes, size_t size, void **state) {
    if (size != sizeof(Model)) return 3;
    if (!*state) *state = malloc(sizeof(Model));
    memcpy(*state, bytes, sizeof(Model));
    return 0;
}

#if FMI == 2
void *fmi2Instantiate(const char *name, int kind, const char *token, const char *resources,
                      const void *callbacks, int visible, int logging) {
    return strcmp(token, "{pantograph}") ? NULL : made();
}
void fmi2FreeInstance(void *m) { free(m); }
int fmi2SetupExperiment(void *m, int has, double tolerance, double start, int ends, double end) {
    ((Model *)m)->time = start;
    return 0;
}
int fmi2EnterInitializationMode(void *m) { return 0; }
int fmi2ExitInitializationMode(void *m) { return 0; }
int fmi2Terminate(void *m) { return 0; }
int fmi2Reset(void *m) { return 0; }
int fmi2SetReal(void *m, const unsigned *r, size_t n, const double *v) { return set(m, r, n, v); }
int fmi2GetReal(void *m, const unsigned *r, size_t n, double *v) { return get(m, r, n, v); }
int fmi2DoStep(void *m, double time, double h, int keep) { return step(m, h); }
int fmi2GetFMUstate(void *m, void **s) { return save(m, s); }
int fmi2SetFMUstate(void *m, void *s) { return restore(m, s); }
int fmi2FreeFMUstate(void *m, void **s) { return forget(s); }
int fmi2SerializedFMUstateSize(void *m, void *s, size_t *size) { return size_of(size); }
int fmi2SerializeFMUstate(void *m, void *s, char *b, size_t size) { return write_to(s, b, size); }
int fmi2DeSerializeFMUstate(void *m, const char *b, size_t size, void **s) {
    return read_from(b, size, s);
}
/* The rest of the interface, which every library has: not used here. */
#define NONE(name) int name(void) { return 3; }
NONE(fmi2CancelStep) NONE(fmi2GetBoolean) NONE(fmi2GetBooleanStatus)
NONE(fmi2GetDirectionalDerivative) NONE(fmi2GetInteger) NONE(fmi2GetIntegerStatus)
NONE(fmi2GetRealOutputDerivatives) NONE(fmi2GetRealStatus) NONE(fmi2GetStatus) NONE(fmi2GetString)
NONE(fmi2GetStringStatus) NONE(fmi2GetTypesPlatform) NONE(fmi2GetVersion) NONE(fmi2SetBoolean)
NONE(fmi2SetDebugLogging) NONE(fmi2SetInteger) NONE(fmi2SetRealInputDerivatives)
NONE(fmi2SetString)
#else
void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources,
                                  bool visible, bool logging, bool events, bool early,
                                  const unsigned *needed, size_t count, void *environment,
                                  void *log, void *update) {
    return strcmp(token, "{pantograph}") ? NULL : made();
}
void fmi3FreeInstance(void *m) { free(m); }
int fmi3EnterInitializationMode(void *m, bool has, double tolerance, double start, bool ends,
                                double end) {
    ((Model *)m)->time = start;
    return 0;
}
int fmi3ExitInitializationMode(void *m) { return 0; }
int fmi3Terminate(void *m) { return 0; }
int fmi3Reset(void *m) { return 0; }
int fmi3SetFloat64(void *m, const unsigned *r, size_t n, const double *v, size_t k) {
    return set(m, r, n, v);
}
int fmi3GetFloat64(void *m, const unsigned *r, size_t n, double *v, size_t k) {
    return get(m, r, n, v);
}
int fmi3DoStep(void *m, double time, double h, bool keep, bool *event, bool *ends, bool *early,
               double *reached) {
    *event = *ends = *early = false;
    *reached = time + h;
    return step(m, h);
}
int fmi3GetFMUState(void *m, void **s) { return save(m, s); }
int fmi3SetFMUState(void *m, void *s) { return restore(m, s); }
int fmi3FreeFMUState(void *m, void **s) { return forget(s); }
int fmi3SerializedFMUStateSize(void *m, void *s, size_t *size) { return size_of(size); }
int fmi3SerializeFMUState(void *m, void *s, unsigned char *b, size_t size) {
    return write_to(s, b, size);
}
int fmi3DeserializeFMUState(void *m, const unsigned char *b, size_t size, void **s) {
    return read_from(b, size, s);
}
/* The rest of the interface, which every library has: not used here. */
#define NONE(name) int name(void) { return 3; }
NONE(fmi3ActivateModelPartition) NONE(fmi3CompletedIntegratorStep)
NONE(fmi3EnterConfigurationMode) NONE(fmi3EnterContinuousTimeMode) NONE(fmi3EnterEventMode)
NONE(fmi3EnterStepMode) NONE(fmi3EvaluateDiscreteStates) NONE(fmi3ExitConfigurationMode)
NONE(fmi3GetAdjointDerivative) NONE(fmi3GetBinary) NONE(fmi3GetBoolean) NONE(fmi3GetClock)
NONE(fmi3GetContinuousStateDerivatives) NONE(fmi3GetContinuousStates)
NONE(fmi3GetDirectionalDerivative) NONE(fmi3GetEventIndicators) NONE(fmi3GetFloat32)
NONE(fmi3GetInt16) NONE(fmi3GetInt32) NONE(fmi3GetInt64) NONE(fmi3GetInt8)
NONE(fmi3GetIntervalDecimal) NONE(fmi3GetIntervalFraction) NONE(fmi3GetNominalsOfContinuousStates)
NONE(fmi3GetNumberOfContinuousStates) NONE(fmi3GetNumberOfEventIndicators)
NONE(fmi3GetNumberOfVariableDependencies) NONE(fmi3GetOutputDerivatives) NONE(fmi3GetShiftDecimal)
NONE(fmi3GetShiftFraction) NONE(fmi3GetString) NONE(fmi3GetUInt16) NONE(fmi3GetUInt32)
NONE(fmi3GetUInt64) NONE(fmi3GetUInt8) NONE(fmi3GetVariableDependencies) NONE(fmi3GetVersion)
NONE(fmi3InstantiateModelExchange) NONE(fmi3InstantiateScheduledExecution) NONE(fmi3SetBinary)
NONE(fmi3SetBoolean) NONE(fmi3SetClock) NONE(fmi3SetContinuousStates) NONE(fmi3SetDebugLogging)
NONE(fmi3SetFloat32) NONE(fmi3SetInt16) NONE(fmi3SetInt32) NONE(fmi3SetInt64) NONE(fmi3SetInt8)
NONE(fmi3SetIntervalDecimal) NONE(fmi3SetIntervalFraction) NONE(fmi3SetShiftDecimal)
NONE(fmi3SetShiftFraction) NONE(fmi3SetString) NONE(fmi3SetTime) NONE(fmi3SetUInt16)
NONE(fmi3SetUInt32) NONE(fmi3SetUInt64) NONE(fmi3SetUInt8) NONE(fmi3UpdateDiscreteStates)
#endif
