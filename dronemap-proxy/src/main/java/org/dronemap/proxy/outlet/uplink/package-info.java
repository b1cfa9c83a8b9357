/**
 * What attached programs send: read as commands of the cloud, answered from what it knows, or refused with a sentence.
 *
 * <p>Enters: a kind of message that programs may send.
 *
 * <p>Never: a frame that goes on to a vehicle as it came.
 */
@NullMarked
package org.dronemap.proxy.outlet.uplink;

import org.jspecify.annotations.NullMarked;
