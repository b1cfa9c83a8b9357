package org.dronemap.ws.access;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Declares on a REST handler who may call it, what it touches, what it costs and what audit record it leaves. Each
 * handler has it: a server with one that has not does not start. The filters act on it before a handler runs and before
 * a body is read; services check what only they know, such as grants, and the role again, as the other faces call them
 * too.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface Access {
    /** The least that a caller must be. */
    AccessLevel from();

    ResourceScope about();

    RequestCost costs() default RequestCost.REQUEST;

    AuditPolicy audit() default AuditPolicy.BY_METHOD;
}
