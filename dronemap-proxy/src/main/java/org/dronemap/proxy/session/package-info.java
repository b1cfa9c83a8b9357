/**
 * Who is who on a link: one session a vehicle, its binding to a drone, and everything under way with it.
 *
 * <p>Enters: what holds for one vehicle on its links.
 *
 * <p>Never: what differs between autopilots.
 */
@NullMarked
package org.dronemap.proxy.session;

import org.jspecify.annotations.NullMarked;
