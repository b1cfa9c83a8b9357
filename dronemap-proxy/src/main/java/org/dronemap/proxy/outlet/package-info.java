/** Where ground stations and programs of other makers attach: signed in by their frames, shown what their user may see. */
@NullMarked
package org.dronemap.proxy.outlet;

import org.jspecify.annotations.NullMarked;
