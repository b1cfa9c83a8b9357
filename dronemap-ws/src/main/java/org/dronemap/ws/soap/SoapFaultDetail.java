package org.dronemap.ws.soap;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlType;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.service.Problem;
import org.jspecify.annotations.Nullable;

/** What a fault says: the same code and sentence as in the other faces. */
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(
        name = "dronemapFault",
        namespace = Namespace.URI,
        propOrder = {"code", "type", "message", "field", "allowed", "retryAfterSeconds", "parameter"})
public class SoapFaultDetail {
    @XmlElement(required = true)
    private String code = "";

    @XmlElement(required = true)
    private String type = "";

    @XmlElement(required = true)
    private String message = "";

    private @Nullable String field;
    private @Nullable String allowed;
    private @Nullable Long retryAfterSeconds;

    @XmlElement
    private List<SoapProblemParameter> parameter = new ArrayList<>();

    static SoapFaultDetail of(Problem problem) {
        SoapFaultDetail detail = new SoapFaultDetail();
        detail.code = problem.code();
        detail.type = problem.type();
        detail.message = problem.detail();
        detail.field = problem.field();
        detail.allowed = problem.allowed();
        detail.retryAfterSeconds = problem.retryAfterSeconds();
        detail.parameter = problem.parameters().entrySet().stream()
                .map(given -> SoapProblemParameter.of(given.getKey(), given.getValue()))
                .toList();
        return detail;
    }

    public String getCode() {
        return code;
    }

    public String getType() {
        return type;
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

    public List<SoapProblemParameter> getParameter() {
        return parameter;
    }
}
