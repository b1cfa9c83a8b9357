/**
 * Store ports kept in memory, for tests; they keep the same contract but for durability.
 *
 * <p>Enters: a stand-in for a port, held to its contract.
 *
 * <p>Never: the product.
 */
@NullMarked
package org.dronemap.store.memory;

import org.jspecify.annotations.NullMarked;
