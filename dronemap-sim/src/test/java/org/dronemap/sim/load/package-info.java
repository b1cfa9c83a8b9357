/** The load programs, tested on real sockets and files. */
@NullMarked
package org.dronemap.sim.load;

import org.jspecify.annotations.NullMarked;
