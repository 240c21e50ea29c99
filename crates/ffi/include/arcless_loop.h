/* Arcless: a line, or a pantograph, that another program steps.
 *
 * The library is `libarcless_loop.so` (`arcless_loop.dll`), which `arcless fmu library DIR` copies
 * beside this header; a model is written by `arcless fmu export SCENARIO --out NAME.loop`.
 *
 *     arcless_loop *line = arcless_loop_open(ARCLESS_LOOP_VERSION, "line.loop", text, sizeof text);
 *     unsigned force = arcless_loop_find(line, "P1.contact_force");
 *     arcless_loop_set(line, &force, &measured, 1);
 *     arcless_loop_step(line);
 *
 * Numbers are SI. Variable 0 is time; the others follow from 1. An input holds until it is set
 * again. Between open and close no set, step or get allocates memory or locks, unless it fails.
 * Devices are independent of one another: each may be used by one thread at a time.
 */
#ifndef ARCLESS_LOOP_H
#define ARCLESS_LOOP_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface. A program passes it to `arcless_loop_open`, which refuses another. */
#define ARCLESS_LOOP_VERSION 1u
/* Number that is of no variable. */
#define ARCLESS_LOOP_NONE 0xFFFFFFFFu

/* Results: all well, or what has failed. `arcless_loop_message` says more. */
enum {
    ARCLESS_LOOP_OK = 0,
    ARCLESS_LOOP_DATA = 1,   /* a file or a state cannot be used; nothing has changed */
    ARCLESS_LOOP_VALUE = 2,  /* no such variable, no input, not finite, a null pointer */
    ARCLESS_LOOP_STEP = 4,   /* the step cannot be taken; the device stands where it stood */
    ARCLESS_LOOP_FAULT = 9   /* a fault of Arcless: close the device */
};

/* Roles of variables. */
enum {
    ARCLESS_LOOP_INDEPENDENT = 0,
    ARCLESS_LOOP_INPUT = 1,
    ARCLESS_LOOP_OUTPUT = 2,
    ARCLESS_LOOP_CONSTANT = 3
};

typedef struct arcless_loop arcless_loop;

/* Version of the interface that the library has. */
unsigned int arcless_loop_version(void);

/* Opens a model and finds its start: milliseconds to seconds. NULL, and a message of at most
 * `room` characters, when it cannot. The path is in UTF-8. */
arcless_loop *arcless_loop_open(unsigned int version, const char *path, char *message, size_t room);

/* Frees a device; NULL is fine. */
void arcless_loop_close(arcless_loop *device);

/* Message of the last failure, until the next one; "" without one. */
const char *arcless_loop_message(const arcless_loop *device);

/* Number of variables, the number of the one with a name, and what each is. */
unsigned int arcless_loop_count(const arcless_loop *device);
unsigned int arcless_loop_find(const arcless_loop *device, const char *name);
const char *arcless_loop_name(const arcless_loop *device, unsigned int number);
const char *arcless_loop_unit(const arcless_loop *device, unsigned int number);
const char *arcless_loop_description(const arcless_loop *device, unsigned int number);
int arcless_loop_role(const arcless_loop *device, unsigned int number);

/* Length of a step in s. */
double arcless_loop_step_length(const arcless_loop *device);

/* Sets inputs, gets values of any variables: `count` numbers and values. */
int arcless_loop_set(arcless_loop *device, const unsigned int *numbers, const double *values,
                     size_t count);
int arcless_loop_get(arcless_loop *device, const unsigned int *numbers, double *values,
                     size_t count);

/* Takes one step. */
int arcless_loop_step(arcless_loop *device);

/* Saves the state into `room` bytes, and sets `size` to the size of the state; with a room of 0
 * only that. A state is restored into any device of the same model. */
int arcless_loop_save(arcless_loop *device, unsigned char *bytes, size_t room, size_t *size);
int arcless_loop_restore(arcless_loop *device, const unsigned char *bytes, size_t size);

/* Returns to the start, with the inputs of the start. */
int arcless_loop_reset(arcless_loop *device);

#ifdef __cplusplus
}
#endif

#endif
