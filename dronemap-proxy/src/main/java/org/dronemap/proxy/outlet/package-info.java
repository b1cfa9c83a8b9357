/**
 * Where ground stations and programs of other makers attach: ways in, one thread for all of them, and taps of vehicles.
 *
 * <p>Enters: a way by which frames of programs or vehicles come in.
 *
 * <p>Never: users' pages.
 */
@NullMarked
package org.dronemap.proxy.outlet;

import org.jspecify.annotations.NullMarked;
