/**
 * Where ground stations and programs of other makers attach: signed in by their frames, shown what their user may see.
 *
 * <p>Enters: what an attached ground station is shown or may ask for.
 *
 * <p>Never: users' pages.
 */
@NullMarked
package org.dronemap.proxy.outlet;

import org.jspecify.annotations.NullMarked;
