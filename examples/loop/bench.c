/* A line stepped from C, as a test bench does: a measured force in, the height of the wire out.
 *
 *     arcless fmu export en50318-ac-simple-320-planar --out line.loop
 *     arcless fmu library .
 *     cc -O2 -I. bench.c -L. -larcless_loop -Wl,-rpath,'$ORIGIN' -lm -o bench
 *     ./bench line.loop 2000
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "arcless_loop.h"

/* What a bench measures; here a force that swings about 120 N. */
static double measured_force(double time)
{
    return 120.0 + 40.0 * sin(20.0 * time);
}

static unsigned int variable(const arcless_loop *line, const char *name)
{
    unsigned int number = arcless_loop_find(line, name);
    if (number == ARCLESS_LOOP_NONE) {
        fprintf(stderr, "the model has no variable %s\n", name);
        exit(2);
    }
    return number;
}

int main(int count, char **arguments)
{
    char message[500];
    if (count != 3) {
        fprintf(stderr, "bench MODEL STEPS\n");
        return 2;
    }
    arcless_loop *line =
        arcless_loop_open(ARCLESS_LOOP_VERSION, arguments[1], message, sizeof message);
    if (!line) {
        fprintf(stderr, "%s\n", message);
        return 1;
    }
    const unsigned int force = variable(line, "P1.contact_force");
    const unsigned int outputs[2] = {variable(line, "P1.wire_height"),
                                     variable(line, "P1.wire_velocity")};
    const double h = arcless_loop_step_length(line);
    const long steps = atol(arguments[2]);
    for (long step = 0; step < steps; step++) {
        double wire[2], newtons = measured_force((double)step * h);
        if (arcless_loop_set(line, &force, &newtons, 1) || arcless_loop_step(line) ||
            arcless_loop_get(line, outputs, wire, 2)) {
            fprintf(stderr, "%s\n", arcless_loop_message(line));
            arcless_loop_close(line);
            return 1;
        }
        /* Here the bench moves its plate to wire[0], with wire[1], and waits for the clock. */
        if ((step + 1) % 500 == 0)
            printf("%.3f s  %.1f N  %.17g m\n", (double)(step + 1) * h, newtons, wire[0]);
    }
    arcless_loop_close(line);
    return 0;
}
