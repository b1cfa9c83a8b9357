/**
 * MAVLink to the words of the house and back; what differs between autopilots stands in one class each.
 *
 * <p>Enters: what differs between autopilots.
 *
 * <p>Never: exchanges that take several messages.
 */
@NullMarked
package org.dronemap.proxy.mavlink.translate;

import org.jspecify.annotations.NullMarked;
