/* How long the steps of a line take on this machine, and how late they are, from C on Linux.
 *
 *     arcless fmu export en50318-ac-simple-320-planar --out line.loop
 *     arcless fmu library .
 *     cc -O2 -I. step_times.c -L. -larcless_loop -Wl,-rpath,'$ORIGIN' -lm -o step_times
 *     ./step_times line.loop 30            30 s of steps, and 30 s of an empty loop
 *     ./step_times line.loop 30 49 3       with SCHED_FIFO 49 and locked memory, on processor 3
 *
 * A step is due each time step of the clock. Printed are the times from being due to being done.
 */
#define _GNU_SOURCE
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <time.h>

#include "arcless_loop.h"

#define NS 1000000000L

static long nanoseconds(struct timespec time)
{
    return time.tv_sec * NS + time.tv_nsec;
}

static int by_size(const void *one, const void *other)
{
    const double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

/* Percentile of sorted times: the least one that so large a part of them does not exceed. */
static double percentile(const double *sorted, long count, double percent)
{
    long place = (long)ceil(percent / 100.0 * (double)count);
    return sorted[place < 1 ? 0 : place - 1];
}

static void print(const char *name, double *late, long count, double step)
{
    long misses = 0;
    for (long i = 0; i < count; i++)
        misses += late[i] > step;
    qsort(late, (size_t)count, sizeof *late, by_size);
    printf("%-11s median %.1f  99 %% %.1f  99.99 %% %.1f  largest %.1f us; %ld of %ld missed\n", name,
           1e6 * percentile(late, count, 50.0), 1e6 * percentile(late, count, 99.0),
           1e6 * percentile(late, count, 99.99), 1e6 * late[count - 1], misses, count);
}

/* What the machine gives a thread that must not be late; an explanation where it does not. */
static int prepare(int priority, int processor)
{
    struct sched_param how = {.sched_priority = priority};
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(processor, &set);
    if (sched_setaffinity(0, sizeof set, &set))
        return perror("processor"), 0;
    if (mlockall(MCL_CURRENT | MCL_FUTURE))
        return perror("locked memory (as root, or `memlock unlimited` in limits.conf)"), 0;
    if (sched_setscheduler(0, SCHED_FIFO, &how))
        return perror("SCHED_FIFO (as root, or `rtprio` in limits.conf)"), 0;
    return 1;
}

static int steps(arcless_loop *line, unsigned int force, double *late, long count, double step)
{
    const long every = lround(step * (double)NS);
    struct timespec due, done;
    clock_gettime(CLOCK_MONOTONIC, &due);
    for (long i = 0; i < count; i++) {
        due.tv_nsec += every;
        due.tv_sec += due.tv_nsec / NS;
        due.tv_nsec %= NS;
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL);
        if (line) {
            const double newtons = 120.0 + 40.0 * sin(20.0 * (double)i * step);
            if (arcless_loop_set(line, &force, &newtons, 1))
                return 0;
            /* At the end of the line it begins again. */
            if (arcless_loop_step(line) &&
                (arcless_loop_reset(line) || arcless_loop_step(line)))
                return 0;
        }
        clock_gettime(CLOCK_MONOTONIC, &done);
        late[i] = 1e-9 * (double)(nanoseconds(done) - nanoseconds(due));
    }
    return 1;
}

int main(int count, char **arguments)
{
    char message[500];
    const double seconds = count > 2 ? atof(arguments[2]) : 0.0;
    if ((count != 3 && count != 5) || !(seconds > 0.0)) {
        fprintf(stderr, "step_times MODEL SECONDS [PRIORITY PROCESSOR]\n");
        return 2;
    }
    arcless_loop *line =
        arcless_loop_open(ARCLESS_LOOP_VERSION, arguments[1], message, sizeof message);
    if (!line)
        return fprintf(stderr, "%s\n", message), 1;
    const double step = arcless_loop_step_length(line);
    const long number = (long)(seconds / step);
    const unsigned int force = arcless_loop_find(line, "P1.contact_force");
    double *late = number > 0 ? malloc((size_t)number * sizeof *late) : NULL;
    if (force == ARCLESS_LOOP_NONE || !late)
        return fprintf(stderr, "no variable P1.contact_force, or no memory for the times\n"), 1;
    for (long i = 0; i < number; i++)
        late[i] = 0.0; /* so that the memory is there */
    if (count == 5 && !prepare(atoi(arguments[3]), atoi(arguments[4])))
        return 1;
    if (!steps(line, force, late, number, step))
        return fprintf(stderr, "%s\n", arcless_loop_message(line)), 1;
    print("steps", late, number, step);
    steps(NULL, 0, late, number, step);
    print("empty loop", late, number, step);
    free(late);
    arcless_loop_close(line);
    return 0;
}
