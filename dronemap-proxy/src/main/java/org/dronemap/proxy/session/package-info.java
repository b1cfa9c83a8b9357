/** Who is who on a link: one session a vehicle, its binding to a drone, and everything under way with it. */
@NullMarked
package org.dronemap.proxy.session;

import org.jspecify.annotations.NullMarked;
