/** Plans flown by simulated vehicles: how well their times and energies were foretold. */
@NullMarked
package org.dronemap.bench.planning.flown;

import org.jspecify.annotations.NullMarked;
