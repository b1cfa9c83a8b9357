/** What keeps hostile and slow clients from harming the web server. */
@NullMarked
package org.dronemap.ws.guard;

import org.jspecify.annotations.NullMarked;
