/** One planning run in a process of its own: reads a problem, searches until its CPU is spent, writes what it found. */
@NullMarked
package org.dronemap.bench.planning;

import org.jspecify.annotations.NullMarked;
