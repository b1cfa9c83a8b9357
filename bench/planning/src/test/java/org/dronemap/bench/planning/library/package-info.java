/** The public solvers, as they are set up, on small problems. */
@NullMarked
package org.dronemap.bench.planning.library;

import org.jspecify.annotations.NullMarked;
