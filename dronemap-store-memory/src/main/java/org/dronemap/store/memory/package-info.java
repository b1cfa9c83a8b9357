/** Store ports kept in memory, for tests; they keep the same contract but for durability. */
@NullMarked
package org.dronemap.store.memory;

import org.jspecify.annotations.NullMarked;
