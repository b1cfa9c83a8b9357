/** Missions under way that lose a drone: how soon there is another plan, and how good it is. */
@NullMarked
package org.dronemap.bench.planning.loss;

import org.jspecify.annotations.NullMarked;
