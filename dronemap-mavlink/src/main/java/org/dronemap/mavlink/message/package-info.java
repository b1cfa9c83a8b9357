/**
 * The messages that this product reads or writes, as records of their raw fields; generated.
 *
 * <p>Enters: a message that dronefleet does not know.
 *
 * <p>Never: hand-written copies of others.
 */
@NullMarked
package org.dronemap.mavlink.message;

import org.jspecify.annotations.NullMarked;
