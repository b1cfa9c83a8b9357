@NullMarked
package org.dronemap.proxy.outlet.client;

import org.jspecify.annotations.NullMarked;
