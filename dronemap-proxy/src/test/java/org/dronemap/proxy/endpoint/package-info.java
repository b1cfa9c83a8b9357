@NullMarked
package org.dronemap.proxy.endpoint;

import org.jspecify.annotations.NullMarked;
