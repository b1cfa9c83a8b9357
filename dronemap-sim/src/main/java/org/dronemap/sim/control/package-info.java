/** Faults on order: a line protocol on a loopback port. */
@NullMarked
package org.dronemap.sim.control;

import org.jspecify.annotations.NullMarked;
