package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlType;
import org.dronemap.ws.service.Problem;
import org.jspecify.annotations.Nullable;

/** What a fault says: the same code and sentence as in the other faces. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "dronemapFault",
        namespace = Namespace.URI,
        propOrder = {"code", "message", "field", "allowed", "retryAfterSeconds"})
public class SoapFaultDetail {
    @XmlElement(required = true)
    private String code = "";

    @XmlElement(required = true)
    private String message = "";

    private @Nullable String field;
    private @Nullable String allowed;
    private @Nullable Long retryAfterSeconds;

    static SoapFaultDetail of(Problem problem) {
        SoapFaultDetail detail = new SoapFaultDetail();
        detail.code = problem.type().substring(problem.type().lastIndexOf(':') + 1);
        detail.message = problem.detail();
        detail.field = problem.field();
        detail.allowed = problem.allowed();
        detail.retryAfterSeconds = problem.retryAfterSeconds();
        return detail;
    }

    public String getCode() {
        return code;
    }

    public String getMessage() {
        return message;
    }

    public @Nullable String getField() {
        return field;
    }

    public @Nullable String getAllowed() {
        return allowed;
    }

    public @Nullable Long getRetryAfterSeconds() {
        return retryAfterSeconds;
    }
}
