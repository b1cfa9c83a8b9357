/**
 * One planning run in a process of its own: reads a problem, searches until its CPU is spent, writes what it found.
 *
 * <p>Enters: what runs and counts.
 *
 * <p>Never: tests.
 */
@NullMarked
package org.dronemap.bench.planning;

import org.jspecify.annotations.NullMarked;
