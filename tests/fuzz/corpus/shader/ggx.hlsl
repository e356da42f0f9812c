// hlsl
static const float PI = 3.14159265f;
cbuffer Material : register(b0) { float gRoughness; float3 gBaseColor; float gMetallic; };
float D_GGX(float NdotH, float a) { float a2 = a*a; float f = (NdotH * a2 - NdotH) * NdotH + 1.0f; return a2 / (PI * f * f); }
float V_Smith(float NdotV, float NdotL, float a) { float a2 = a*a; return 0.5f / (NdotL * sqrt(NdotV * NdotV * (1 - a2) + a2) + NdotV * sqrt(NdotL*NdotL*(1-a2)+a2)); }
float3 F_Schlick(float u, float3 f0) { return f0 + (1.0f - f0) * pow(1.0f - u, 5.0f); }
float3 BRDF(float3 L, float3 V, float3 N)
{
  float3 H = normalize(L + V);
  float NdotL = saturate(dot(N, L)), NdotV = abs(dot(N, V)) + 1e-5f, NdotH = saturate(dot(N, H)), LdotH = saturate(dot(L, H));
  float a = gRoughness * gRoughness;
  float3 f0 = lerp(0.04f.xxx, gBaseColor, gMetallic);
  return (1 - gMetallic) * gBaseColor / PI + D_GGX(NdotH, a) * V_Smith(NdotV, NdotL, a) * F_Schlick(LdotH, f0);
}
